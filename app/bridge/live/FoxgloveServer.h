#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/bridge/live/FoxgloveMessages.h"
#include "app/bridge/live/WebSocketServer.h"

/// A server for the Foxglove WebSocket protocol, version 1, for Foxglove, Lichtblick and
/// PlotJuggler: topics, services, parameters and the simulation clock.
namespace live {

using ChannelId = std::uint32_t;

/// A type name, for example "sensor_msgs/msg/LaserScan", and its ros2msg definition.
struct Schema {
  std::string name, text;
};

/// A published topic.
struct Channel {
  std::string topic;  // "/scan"
  Schema schema;
  bool isLatched = false;  // the newest message is kept
};

struct ServiceAnswer {
  bool isFine = true;
  std::string payload;  // response in the call's encoding, or the error text
};
struct Service {
  std::string name, type;  // "/hunavsim/pause", "std_srvs/srv/SetBool"
  Schema request, response;
  std::function<ServiceAnswer(std::string_view encoding, std::string_view payload)> call;
};

/// A topic that clients can publish.
struct ClientTopic {
  std::string topic, schemaName;
  /// Returns an error text; empty on success.
  std::function<std::string(std::string_view encoding, std::string_view payload)> take;
};

struct Parameter {
  std::string name;
  std::function<ParameterValue()> get;
  /// Returns an error text; empty on success. Null: read-only.
  std::function<std::string(const ParameterValue&)> set;
};

struct FoxgloveSettings {
  ServerSettings server;
  std::string name = "hunavsim", session;  // shown by the client; the session id is unique per run
  std::vector<Service> services;
  std::vector<ClientTopic> clientTopics;  // empty: clients cannot publish
  std::vector<Parameter> parameters;      // empty: no parameters
  std::function<void()> tick;             // called about ten times per second; may be null
  std::function<void()>
      subscribed;  // a subscription lacks a message (`isMessageAwaited`); may be null
  std::function<void(const std::string& origin)> refused;  // a page was rejected; may be null
};

/// The callbacks in the settings are called in the server's thread, one at a time, and must not
/// call the server. The public functions may be called from any other thread.
class FoxgloveServer : private WebSocketServer::Handler {
 public:
  /// Starts listening. Clients are served after `start`. Errors: those of WebSocketServer.
  static base::Result<std::unique_ptr<FoxgloveServer>> listen(FoxgloveSettings settings,
                                                              const std::vector<Channel>& channels);
  ~FoxgloveServer() override;
  FoxgloveServer(const FoxgloveServer&) = delete;
  FoxgloveServer& operator=(const FoxgloveServer&) = delete;
  FoxgloveServer(FoxgloveServer&&) = delete;
  FoxgloveServer& operator=(FoxgloveServer&&) = delete;

  std::uint16_t port() const { return server_->port(); }
  void start() { server_->start(); }
  void stop(std::string_view reason) { server_->stop(reason); }

  /// Whether the channel has subscribers or is latched. If not, the message need not be created.
  bool isWanted(ChannelId channel) const;  // numbered from 1 in order of creation
  struct Message {
    ChannelId channel = 0;
    SharedBytes payload;  // CDR with encapsulation header
  };
  /// Whether a subscription to the channel has received no message yet.
  bool isMessageAwaited(ChannelId channel) const {
    return publishedChannels_.at(channel - 1).awaited > 0;
  }
  enum class Recipients { All, Awaiting };  // Awaiting: subscriptions that have received none yet
  /// Publishes messages of one time [ns of simulation time] and the time itself, which is omitted
  /// for clients without awaiting subscriptions if only these are recipients.
  void publish(std::uint64_t time, const std::vector<Message>& messages,
               Recipients recipients = Recipients::All);
  std::size_t clientCount() const { return clientCount_; }
  bool hadClient() const { return hadClients_; }  // a client has ever connected

 private:
  using Client = WebSocketServer::Client;
  struct ClientSubscription {
    std::uint32_t subscription = 0;
    bool isMessageAwaited = true;  // no message sent yet
  };
  struct OwnChannel {
    const ClientTopic* topic;  // of the settings
    std::string encoding;
  };
  struct ClientState {  // state of one client
    std::map<ChannelId, ClientSubscription> wanted;
    std::map<std::uint32_t, OwnChannel> own;  // channels advertised by the client
    std::set<std::string> watched;            // subscribed parameters
    bool isWarnedOfLoss = false;
  };
  struct PublishedChannel {  // a published channel
    Channel channel;
    std::atomic<int> wanted{0}, awaited{0};
    std::uint64_t time = 0;  // of the newest message, if latched
    SharedBytes newest;
  };

  explicit FoxgloveServer(FoxgloveSettings settings) : settings_(std::move(settings)) {}
  void opened(Client client) override;
  void received(Client client, bool isText, const std::string& message) override;
  void closed(Client client) override;
  void refused(const std::string& origin) override;
  void tick() override;

  void answer(Client client, const request::Subscribe& asked);
  void answer(Client client, const request::Unsubscribe& asked);
  void answer(Client client, const request::Advertise& asked);
  void answer(Client client, const request::Unadvertise& asked);
  void answer(Client client, const request::GetParameters& asked);
  void answer(Client client, const request::SetParameters& asked);
  void answer(Client client, const request::WatchParameters& asked);
  void answer(Client client, const request::Publish& asked);
  void answer(Client client, const request::CallService& asked);
  void answer(Client client, const request::Refused& asked);
  std::string subscribe(Client client, const Subscription& wanted);
  void removeSubscription(ChannelId channel, const ClientSubscription& wanted);
  void warnOfLoss(Client client, ClientState& state);
  void sendParameters();
  void publishTo(Client client, ClientState& state, std::uint64_t time,
                 const std::vector<Message>& messages, Recipients recipients);
  void sendMessage(Client client, ChannelId channel, ClientSubscription& wanted, std::uint64_t time,
                   const SharedBytes& payload, SendQueue::Kind kind);
  void send(Client client, const std::string& text);
  void sendError(Client client, const std::vector<std::string>& problems);

  const FoxgloveSettings settings_;
  std::deque<PublishedChannel> publishedChannels_;  // index 0 is channel 1
  std::string greeting_, channels_, services_;      // sent to each new client
  std::map<Client, ClientState> clientStates_;
  std::map<std::string, ParameterValue> sentParameters_;  // last published values
  std::atomic<std::size_t> clientCount_{0};
  std::atomic<bool> hadClients_{false};
  std::unique_ptr<WebSocketServer> server_;  // last member: its thread uses the others
};

}  // namespace live
