#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

#include "app/bridge/groot/GrootServer.h"
#include "bt/tree/TreeSpec.h"
#include "sim2d/world/World.h"

namespace groot {

/// The tree of one person of a run before the eyes of Groot2. Of the run nothing changes. Used in
/// the thread that runs; the world must outlive it.
class GrootRun {
 public:
  /// `human`: index in the world; `tree`: what that person runs. Errors: as of GrootServer, and a
  /// tree with more nodes than Groot2 can tell apart.
  static base::Result<std::unique_ptr<GrootRun>> open(std::uint16_t port, sim2d::World& world,
                                                      int human, const bt::TreeTable& tree);

  std::uint16_t port() const { return server_->port(); }
  bool wasWatched() const { return server_->wasWatched(); }
  /// Each state once, in order.
  void show(const sim2d::Frame& frame);

 private:
  GrootRun(sim2d::World& world, int human, std::unique_ptr<GrootServer> server);

  sim2d::World& world_;
  int human_ = 0;
  int id_ = 0;
  std::optional<std::chrono::steady_clock::time_point> told_;  // the blackboard
  std::unique_ptr<GrootServer> server_;
};

}  // namespace groot
