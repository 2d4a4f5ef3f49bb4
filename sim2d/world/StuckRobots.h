#pragma once

#include <optional>
#include <vector>

#include "sim2d/nav/StuckDetector.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Detects stuck robots: those with a goal that have come no 0.1 m nearer to it, along the path
/// around the walls, for WorldModel::stuckAfter seconds. Robots that have not started yet do not
/// count, nor robots without a path while a door will still toggle. Not thread-safe.
class StuckRobots {
 public:
  explicit StuckRobots(const WorldModel& model);

  /// Call after each step. Emits `stuck` when a robot becomes stuck.
  void update(const WorldModel& model, WorldState& state, const NavigationMap& navigation,
              bool willDoorToggle);
  /// [s]; reset when it has come half a metre nearer, or has another goal.
  std::optional<double> stuckSince(std::size_t robot) const;

 private:
  struct MonitoredRobot {
    StuckDetector watch;
    std::optional<double> since;
  };
  std::vector<MonitoredRobot> robots_;  // empty: not enabled
  double nextCheck_ = 0.0;              // [s]
};

}  // namespace sim2d
