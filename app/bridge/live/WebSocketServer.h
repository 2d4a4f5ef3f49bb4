#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "app/bridge/live/Connection.h"
#include "sim2d/base/FileDescriptor.h"
#include "sim2d/base/Result.h"

namespace live {

constexpr std::size_t kMostClients = 32;  // simultaneous open connections
/// Simultaneous connections whose request is incomplete or was rejected. Beyond this number the
/// oldest is closed, so that incomplete requests do not block other clients.
constexpr std::size_t kMostUnopened = 64;

/// Address and limits of a server.
struct ServerSettings {
  std::string address = "127.0.0.1";  // numeric IPv4 or IPv6 address
  std::uint16_t port = 0;             // 0: any free port
  std::size_t mostClients = kMostClients;
  ConnectionLimits rules;
};

/// A WebSocket server on POSIX sockets, with one thread for all clients.
class WebSocketServer {
 public:
  using Client = int;  // never reused

  /// Callbacks, called in the server's thread, one at a time and never concurrently with
  /// `exclusively`. They may call `find` and `close`.
  class Handler {
   public:
    virtual ~Handler() = default;
    virtual void opened(Client client) = 0;
    virtual void received(Client client, WebSocketMessage&& message) = 0;  // text or binary
    virtual void closed(Client client) = 0;               // only for opened clients
    virtual void refused(const std::string& origin) = 0;  // a page was rejected
    virtual void tick() {}                                // at least ten times per second
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

  /// Calls `work` while the server's thread is blocked. Do not call from the server's thread.
  void exclusively(const std::function<void()>& work);

  // Call only within `exclusively` or the handler. Closed clients are ignored.
  Connection* find(Client client);
  void close(Client client, CloseCode code, std::string_view reason);

 private:
  struct Peer {
    base::FileDescriptor socket;
    Connection connection;
    bool isOpened = false, isShut = false;
  };
  WebSocketServer(const ServerSettings& settings, Handler& handler);
  base::Diagnostics open();
  void serve();
  void acceptAll(Clock::time_point now);
  void acceptOne(base::FileDescriptor socket, Clock::time_point now);
  /// Closes the oldest unopened connections until at most `most` remain. Returns the number closed.
  std::size_t limitUnopened(std::size_t most);
  bool isFull() const;
  void serveClients(const std::map<Client, short>& ready, Clock::time_point now);
  void serveClient(Client client, Peer& peer, short ready, Clock::time_point now);
  void readFrom(Client client, Peer& peer, Clock::time_point now);
  void end(Client client);
  bool isDone(Clock::time_point now) const;
  std::unique_lock<std::mutex> lockFairly();
  void wake() const;

  const ServerSettings settings_;
  Handler& handler_;
  std::uint16_t port_ = 0;
  base::FileDescriptor listener_, wakeEvent_;
  std::mutex turnMutex_;  // held while waiting for mutex_, for fairness
  std::mutex mutex_;      // guards the members below
  std::map<Client, Peer> peers_;
  Client last_ = 0;
  Clock::time_point acceptRetryAt_{};  // after accept failed for lack of resources
  bool isEnding_ = false;
  Clock::time_point endAt_{};
  std::thread thread_;
};

}  // namespace live
