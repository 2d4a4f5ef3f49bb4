#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "app/bridge/live/SendQueue.h"
#include "sim2d/base/Result.h"

namespace live {

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
