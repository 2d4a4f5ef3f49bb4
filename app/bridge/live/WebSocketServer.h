#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"

namespace live {

/// Bytes shared by the queues of several clients.
using SharedBytes = std::shared_ptr<const std::string>;

constexpr std::size_t kMaxQueuedMessages = std::size_t{8} << 20U;   // [B], per client
constexpr std::size_t kMaxQueuedReplies = std::size_t{256} << 10U;  // [B], per client

/// The messages that wait to be sent to one client. Topic messages may be dropped, oldest first;
/// responses never are. Not thread-safe.
class SendQueue {
 public:
  enum class Kind { Text, Response, Topic };  // Text: a response as JSON; the others are binary
  /// `head` and `body` are sent as one message.
  struct Message {
    Kind kind = Kind::Text;
    std::string head;
    SharedBytes body = nullptr;
  };

  /// `limit`: bytes of queued topic messages, above which the oldest are dropped.
  explicit SendQueue(std::size_t limit = kMaxQueuedMessages) : limit_(limit) {}

  /// Responses do not cause messages to be dropped; instead, reading from a client with many queued
  /// responses is suspended (`hasManyReplies`). The newest message is not dropped, even if it is
  /// larger than the limit.
  void add(Message message) {
    sumOf(message.kind) += costOf(message);
    messages_.push_back(std::move(message));
    auto each = std::next(messages_.begin(), isFirstStarted_ ? 1 : 0);
    while (topicBytes_ > limit_ && each != messages_.end() && std::next(each) != messages_.end()) {
      if (each->kind == Kind::Topic) {
        topicBytes_ -= costOf(*each);
        ++dropped_;
        each = messages_.erase(each);
      } else {
        ++each;
      }
    }
  }
  /// Returns the oldest message, which is no longer dropped and stays valid until `removeFirst`.
  /// The queue must not be empty.
  const Message& startFirst() {
    isFirstStarted_ = true;
    return messages_.front();
  }
  void removeFirst() {
    sumOf(messages_.front().kind) -= costOf(messages_.front());
    messages_.pop_front();
    isFirstStarted_ = false;
  }

  bool isEmpty() const { return messages_.empty(); }
  bool hasManyReplies() const { return replyBytes_ > kMaxQueuedReplies; }
  std::size_t droppedCount() const { return dropped_; }  // number of messages dropped

 private:
  /// With the memory overhead of a message [B].
  static std::size_t costOf(const Message& message) {
    constexpr std::size_t kOverhead = 128;
    return message.head.size() + (message.body ? message.body->size() : 0) + kOverhead;
  }
  std::size_t& sumOf(Kind kind) { return kind == Kind::Topic ? topicBytes_ : replyBytes_; }

  std::size_t limit_;
  std::list<Message> messages_;  // a list, because the first one is read while others are dropped
  bool isFirstStarted_ = false;
  std::size_t topicBytes_ = 0, replyBytes_ = 0, dropped_ = 0;
};

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLongestRequest = 8192;                   // [B], limit for the HTTP request
constexpr std::size_t kLargestMessage = std::size_t{1} << 20U;  // [B], limit for client messages
constexpr std::size_t kMostClients = 32;                        // simultaneous open connections
/// Simultaneous connections whose request is incomplete or was rejected. Beyond this number the
/// oldest is closed, so that incomplete requests do not block other clients.
constexpr std::size_t kMostUnopened = 64;

/// Address, accepted clients and limits of a server.
struct ServerSettings {
  std::string address = "127.0.0.1";   // numeric IPv4 or IPv6 address
  std::uint16_t port = 0;              // 0: any free port
  std::vector<std::string> protocols;  // supported subprotocols
  std::vector<std::string> origins;    // allowed page origins besides the defaults
  std::size_t mostClients = kMostClients;
  std::size_t largestMessage = kLargestMessage;
  std::size_t maxQueuedMessages = kMaxQueuedMessages;
  std::chrono::milliseconds handshakeTime{10000};  // limit for the complete request
  std::chrono::milliseconds idleTimeout{20000};    // then ping; after twice that: lost
  std::chrono::milliseconds closeTime{2000};       // limit for the closing handshake
};

class Connection;

/// Whether a page with this origin may connect. Browsers send the origin of the page that opens a
/// connection, so that other pages can neither watch nor control a run. Allowed are Foxglove's
/// pages (https://app.foxglove.dev, https://studio.foxglove.dev), local files, as used by the
/// desktop app, pages of this machine (localhost, 127.0.0.1, [::1]), and those in `more`. `null` is
/// not allowed, because any page can produce it.
bool isAllowedOrigin(std::string_view origin, const std::vector<std::string>& more = {});

/// A WebSocket server (RFC 6455) with one thread for all clients.
class WebSocketServer {
 public:
  using Client = int;  // never reused

  /// Callbacks, called in the server's thread, one at a time. They may call `send`.
  class Handler {
   public:
    virtual ~Handler() = default;
    virtual void opened(Client client) = 0;
    virtual void received(Client client, bool isText, const std::string& message) = 0;
    virtual void closed(Client client) = 0;               // only for opened clients
    virtual void refused(const std::string& origin) = 0;  // a page was rejected
    virtual void tick() {}                                // about ten times per second
  };

  /// Errors: the port is not available or the address is not local. `handler` must outlive the
  /// server.
  static base::Result<std::unique_ptr<WebSocketServer>> listen(const ServerSettings& settings,
                                                               Handler& handler);
  ~WebSocketServer();  // stops
  WebSocketServer(const WebSocketServer&) = delete;
  WebSocketServer& operator=(const WebSocketServer&) = delete;
  WebSocketServer(WebSocketServer&&) = delete;
  WebSocketServer& operator=(WebSocketServer&&) = delete;

  std::uint16_t port() const { return port_; }
  /// Starts serving clients. Call once.
  void start();
  /// Sends a close frame with the reason to all clients, waits at most 1 s for their queues and
  /// stops. Do not call from the server's thread.
  void stop(std::string_view reason);

  /// Calls `work` in the server's thread and waits until it is done; calls it directly if the
  /// server is not serving clients. Do not call from the server's thread or during `stop`.
  void exclusively(const std::function<void()>& work);

  // Call only within `exclusively` or the handler. Closed clients are ignored.
  void send(Client client, SendQueue::Message message);
  std::size_t droppedCount(Client client) const;  // messages dropped from the client's queue

 private:
  friend class Connection;
  struct Io;

  WebSocketServer(const ServerSettings& settings, Handler& handler);
  base::Diagnostics open();
  void serve();
  void tick();
  void awaitClients();
  void acceptAll();
  void acceptOne(int socket);
  /// Closes the oldest unopened connections until at most `most` remain. Returns the number closed.
  std::size_t limitUnopened(std::size_t most);
  bool isFull() const;
  std::vector<std::shared_ptr<Connection>> connections() const;
  void remove(Client client);

  const ServerSettings settings_;
  Handler& handler_;
  std::unique_ptr<Io> io_;
  std::uint16_t port_ = 0;
  std::map<Client, std::shared_ptr<Connection>> connections_;  // used in the server's thread
  Client last_ = 0;
  std::optional<Clock::time_point> acceptAgainAt_;  // after accept failed for lack of resources
  std::optional<Clock::time_point> endAt_;          // after `stop`
  std::thread thread_;
};

}  // namespace live
