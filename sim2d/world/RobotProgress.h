#pragma once

#include <optional>
#include <vector>

#include "sim2d/nav/StuckWatch.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Notices robots that do not get on: on the way to a goal, and for WorldModel::stuckAfter seconds
/// no 0.1 m nearer to it, along the way round the walls. Who has not set off yet does not count,
/// nor who has no way yet while some door will still open or close. Thread: one at a time.
class RobotProgress {
 public:
  explicit RobotProgress(const WorldModel& model);

  /// After each step. Emits `stuck` when a robot begins to be it.
  void update(const WorldModel& model, WorldState& state, const NavigationMap& navigation,
              bool willDoorToggle);
  /// [s]; until it has come half a metre nearer, or has another goal.
  std::optional<double> stuckSince(std::size_t robot) const;

 private:
  struct Watched {
    StuckWatch watch;
    std::optional<double> since;
  };
  std::vector<Watched> robots_;  // empty: nobody asked for it
  double nextLook_ = 0.0;        // [s]
};

}  // namespace sim2d
