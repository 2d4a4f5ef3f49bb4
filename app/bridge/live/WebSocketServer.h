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
#include "sim2d/base/Result.h"
#include "sim2d/nav/external/Descriptor.h"

namespace live {

constexpr std::size_t kMostClients = 32;  // simultaneous open connections
/// Simultaneous unopened connections: their request is incomplete or was refused. Beyond this
/// number the oldest is closed, so that incomplete requests block no other client.
constexpr std::size_t kMostUnopened = 64;

/// Where a server listens and whom it serves.
struct ServerSettings {
  std::string address = "127.0.0.1";  // as digits, of version 4 or 6
  std::uint16_t port = 0;             // 0: any that is free
  std::size_t mostClients = kMostClients;
  ConnectionRules rules;
};

/// A server of WebSocket on sockets of the system: one thread of its own for all clients.
class WebSocketServer {
 public:
  using Client = int;  // never used twice

  /// Called in the server's thread, one at a time and never beside `exclusively`; may call what
  /// stands under "within" below.
  class Handler {
   public:
    virtual ~Handler() = default;
    virtual void opened(Client client) = 0;
    virtual void received(Client client, WebSocketMessage&& message) = 0;  // Text or Binary
    virtual void closed(Client client) = 0;               // only of those that were opened
    virtual void refused(const std::string& origin) = 0;  // a page that may not connect
    virtual void tick() {}                                // ten times a second or more often
  };

  /// Errors: the port is not to be had, the address is none of this machine. `handler` must outlive
  /// the server.
  static base::Result<std::unique_ptr<WebSocketServer>> listen(const ServerSettings& settings,
                                                               Handler& handler);
  ~WebSocketServer();  // stops
  WebSocketServer(const WebSocketServer&) = delete;
  WebSocketServer& operator=(const WebSocketServer&) = delete;
  WebSocketServer(WebSocketServer&&) = delete;
  WebSocketServer& operator=(WebSocketServer&&) = delete;

  std::uint16_t port() const { return port_; }
  /// Once. From now on clients are served.
  void start();
  /// Tells all clients why, waits a second at most until they have got what waits for them, and
  /// ends. Not from the server's thread.
  void stop(std::string_view reason);

  /// Does `work` while the server's thread does nothing; not from that thread.
  void exclusively(const std::function<void()>& work);

  // within `exclusively` and the handler; clients that are gone are left alone
  Connection* find(Client client);
  void close(Client client, CloseCode code, std::string_view reason);

 private:
  struct Peer {
    sim2d::Descriptor socket;
    Connection connection;
    bool wasOpened = false, isShut = false;
  };
  WebSocketServer(const ServerSettings& settings, Handler& handler);
  base::Diagnostics open();
  void serve();
  void acceptAll(Clock::time_point now);
  void acceptOne(sim2d::Descriptor socket, Clock::time_point now);
  /// Closes the oldest connections that have not opened, until so many are left; returns how many
  /// were closed.
  std::size_t limitUnopened(std::size_t most);
  bool isFull() const;
  void serveClients(const std::map<Client, short>& ready, Clock::time_point now);
  void serveClient(Client client, Peer& peer, short ready, Clock::time_point now);
  void readFrom(Client client, Peer& peer, Clock::time_point now);
  void end(Client client);
  bool isDone(Clock::time_point now) const;
  std::unique_lock<std::mutex> lockInTurn();
  void wake() const;

  const ServerSettings settings_;
  Handler& handler_;
  std::uint16_t port_ = 0;
  sim2d::Descriptor listener_, bell_;
  std::mutex gate_;   // is held by whoever waits for the other: so both sides get their turn
  std::mutex mutex_;  // guards all below
  std::map<Client, Peer> peers_;
  Client last_ = 0;
  Clock::time_point acceptAgain_{};  // after the system had no socket for another client
  bool isEnding_ = false;
  Clock::time_point endAt_{};
  std::thread thread_;
};

}  // namespace live
