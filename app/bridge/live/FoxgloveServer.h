#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/bridge/live/ClientRequest.h"
#include "app/bridge/live/WebSocketServer.h"

/// The server's side of the Foxglove WebSocket protocol, version 1, for Foxglove, Lichtblick and
/// PlotJuggler: topics, services, parameters and the clock of a simulation.
namespace live {

using ChannelId = std::uint32_t;

/// What is published.
struct Channel {
  std::string topic, schemaName, schema;  // "/scan", "sensor_msgs/msg/LaserScan", text of ros2msg
  bool isLatched = false;                 // its newest message is kept
};

/// The text of a type in ros2msg, with its name.
struct Schema {
  std::string name, text;
};

struct ServiceAnswer {
  bool isFine = true;
  std::string payload;  // in the encoding of the call; else why the call failed
};
struct Service {
  std::string name, type;  // "/hunavsim/pause", "std_srvs/srv/SetBool"
  Schema request, response;
  std::function<ServiceAnswer(std::string_view encoding, std::string_view payload)> call;
};

/// What clients may publish.
struct Inlet {
  std::string topic, schemaName;
  /// Returns what is wrong with the message; empty: it was taken.
  std::function<std::string(std::string_view encoding, std::string_view payload)> take;
};

struct Parameter {
  std::string name;
  std::function<ParameterValue()> get;
  /// Returns what is wrong with the value; empty: it counts now. Null: nobody may set it.
  std::function<std::string(const ParameterValue&)> set;
};

struct FoxgloveSettings {
  ServerSettings server;
  std::string name = "hunavsim", session;  // shown by the app; another one for each run
  std::vector<Service> services;
  std::vector<Inlet> inlets;          // none: clients publish nothing
  std::vector<Parameter> parameters;  // none: there are none
  std::function<void()> tick;         // called ten times a second or more often; may be null
  std::function<void()> subscribed;   // a subscription has no message yet (`isAwaited`); idem
  std::function<void(const std::string& origin)> refused;  // a page that may not connect; idem
};

/// Functions of the settings are called in the server's thread, one at a time; they must not call
/// the server. What is called of the server may be called in any other thread.
class FoxgloveServer : private WebSocketServer::Handler {
 public:
  /// It listens, but serves nobody before `start`. Errors: as of WebSocketServer.
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

  /// Somebody has subscribed, or it is latched: else there is no need to make the message.
  bool isWanted(ChannelId channel) const;  // channels are numbered from 1 on, in their order
  struct Message {
    ChannelId channel = 0;
    SharedBytes payload;  // CDR with its head
  };
  /// Messages of one instant [ns of simulated time], which is told as well.
  void publish(std::uint64_t time, const std::vector<Message>& messages);
  /// A subscription to the channel has had no message yet.
  bool isAwaited(ChannelId channel) const { return outlets_.at(channel - 1)->awaited > 0; }
  /// Messages of the newest instant, only for subscriptions that have had none yet.
  void catchUp(std::uint64_t time, const std::vector<Message>& messages);
  /// A parameter was changed by somebody else than a client: whoever watches it is told.
  void noteParameters();
  std::size_t clientCount() const { return clientCount_; }
  bool hadClients() const { return hadClients_; }  // now or before

 private:
  using Client = WebSocketServer::Client;
  struct Wanted {
    std::uint32_t subscription = 0;
    bool isAwaited = true;  // no message came so far
  };
  struct Table {  // of one client
    std::map<ChannelId, Wanted> wanted;
    std::map<std::uint32_t, ClientChannel> own;  // channels that it publishes on
    std::set<std::string> watched;               // parameters
    bool isToldOfLoss = false;
  };
  struct Outlet {  // a channel while it is served
    Channel channel;
    std::atomic<int> wanted{0}, awaited{0};
    std::uint64_t time = 0;  // of the newest message, if it is latched
    SharedBytes newest;
  };

  explicit FoxgloveServer(FoxgloveSettings settings) : settings_(std::move(settings)) {}
  void opened(Client client) override;
  void received(Client client, WebSocketMessage&& message) override;
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
  void unsubscribe(Table& table, std::uint32_t subscription);
  void tellParameters();
  void publish(std::uint64_t time, const std::vector<Message>& messages, bool onlyAwaited);
  struct Publication {
    std::uint64_t time;        // [ns]
    const std::string& clock;  // the time as a message, the same for all clients
    const std::vector<Message>& messages;
  };
  void publishTo(Client client, Table& table, const Publication& publication, bool onlyAwaited);
  void sendMessage(Client client, ChannelId channel, Wanted& wanted, std::uint64_t time,
                   const SharedBytes& payload, Outbox::Kind kind);
  void leave(ChannelId channel, const Wanted& wanted);
  void tellLoss(Client client, Table& table);
  const Parameter* parameter(const std::string& name) const;
  void tell(Client client, const std::string& text);
  void complain(Client client, const std::string& why);

  const FoxgloveSettings settings_;
  std::vector<std::unique_ptr<Outlet>> outlets_;  // channel 1 first
  std::string greeting_, channels_, services_;    // sent to each client
  std::map<Client, Table> tables_;
  std::map<std::string, ParameterValue> told_;  // as they were told last
  std::atomic<std::size_t> clientCount_{0};
  std::atomic<bool> hadClients_{false};
  std::unique_ptr<WebSocketServer> server_;  // goes first: its thread uses all else
};

}  // namespace live
