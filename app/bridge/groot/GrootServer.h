#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>

#include "app/bridge/groot/WatchedRun.h"
#include "sim2d/base/Result.h"

namespace groot {

/// Answers Groot2 on a port of this machine (ZeroMQ, REP), in a thread of its own. The port behind
/// it is taken as well: Groot2 listens there for breakpoints, of which there are none.
class GrootServer {
 public:
  /// Errors: the ports are not to be had. `port` 0: two free ones.
  static base::Result<std::unique_ptr<GrootServer>> listen(std::uint16_t port, WatchedRun run);
  ~GrootServer();
  GrootServer(const GrootServer&) = delete;
  GrootServer& operator=(const GrootServer&) = delete;
  GrootServer(GrootServer&&) = delete;
  GrootServer& operator=(GrootServer&&) = delete;

  std::uint16_t port() const { return port_; }
  /// With the run to itself; from any thread.
  template <class Change>
  void change(Change change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    change(run_);
  }
  bool wasWatched() const { return wasAsked_; }  // a request came, now or before

 private:
  struct Sockets;
  GrootServer(std::unique_ptr<Sockets> sockets, std::uint16_t port, WatchedRun run);
  void serve();
  void answerOne();

  std::unique_ptr<Sockets> sockets_;  // of the thread
  std::uint16_t port_ = 0;
  mutable std::mutex mutex_;
  WatchedRun run_;
  std::atomic<bool> wasAsked_{false};
  std::atomic<bool> isOver_{false};
  std::thread thread_;
};

}  // namespace groot
