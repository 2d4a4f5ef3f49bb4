#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "app/bridge/groot/GrootProtocol.h"
#include "bt/tree/TreeSpec.h"
#include "sim2d/base/Result.h"
#include "sim2d/world/World.h"

namespace groot {

/// Serves Groot2 on a local port (ZeroMQ, REP) in its own thread. The next port is also bound:
/// Groot2 connects to it for breakpoints, which are not supported.
class GrootServer {
 public:
  /// Errors: the ports are not available. `port` 0: two free ports.
  static base::Result<std::unique_ptr<GrootServer>> listen(std::uint16_t port, GrootProtocol run);
  ~GrootServer();
  GrootServer(const GrootServer&) = delete;
  GrootServer& operator=(const GrootServer&) = delete;
  GrootServer(GrootServer&&) = delete;
  GrootServer& operator=(GrootServer&&) = delete;

  std::uint16_t port() const { return port_; }
  /// Calls `change` with exclusive access to the run. Thread-safe.
  template <class Change>
  void change(Change change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    change(run_);
  }
  bool hadClient() const { return hadRequest_; }  // a request has ever arrived

 private:
  struct Sockets;
  GrootServer(std::unique_ptr<Sockets> sockets, std::uint16_t port, GrootProtocol run);
  void serve();

  std::unique_ptr<Sockets> sockets_;  // used by the thread
  std::uint16_t port_ = 0;
  std::mutex mutex_;
  GrootProtocol run_;
  std::atomic<bool> hadRequest_{false};
  std::atomic<bool> isStopping_{false};
  std::thread thread_;
};

/// Publishes the behavior tree of one person of a run to Groot2. Does not affect the run. Used in
/// the thread of the run; the world must outlive it.
class GrootPublisher {
 public:
  /// `human`: index in the world; `tree`: the tree of that person. Errors: those of GrootServer,
  /// and a tree with more nodes than Groot2 supports.
  static base::Result<std::unique_ptr<GrootPublisher>> open(std::uint16_t port, sim2d::World& world,
                                                            int human, const bt::TreeTable& tree);

  std::uint16_t port() const { return server_->port(); }
  bool hadClient() const { return server_->hadClient(); }
  /// Call for each state once, in order.
  void show(const sim2d::Frame& frame);

 private:
  GrootPublisher(sim2d::World& world, int human, std::unique_ptr<GrootServer> server);

  sim2d::World& world_;
  int human_ = 0;
  int id_ = 0;
  std::optional<std::chrono::steady_clock::time_point> lastBlackboard_;  // last blackboard update
  std::unique_ptr<GrootServer> server_;
};

}  // namespace groot
