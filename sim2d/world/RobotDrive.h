#pragma once

#include <map>
#include <memory>
#include <vector>

#include "sim2d/world/PersonMotion.h"
#include "sim2d/world/planners/RobotController.h"

namespace sim2d {

/// The robots: what they see, what their planners say, what their limits leave of it, goals.
class RobotDrive {
 public:
  explicit RobotDrive(std::vector<std::shared_ptr<RobotController>> controllers)
      : controllers_(std::move(controllers)) {}

  /// In the next `command` instead of what the planner says.
  void steer(std::size_t robot, const base::Twist2& command) { steered_[robot] = command; }
  /// Commands of this step, within the limits of speed and acceleration. Emits `replan`.
  const std::vector<base::Twist2>& command(const FrozenWorld& world, WorldState& state);
  /// After the step: goals reached, arrivals.
  static void afterMotion(const WorldModel& model, WorldState& state);

  std::vector<Vec2> path(std::size_t robot, const WorldModel& model, const WorldState& state) const;

 private:
  std::vector<std::shared_ptr<RobotController>> controllers_;
  std::vector<base::Twist2> commands_;
  std::map<std::size_t, base::Twist2> steered_;
  Observation observation_;  // its memory is used again
};

}  // namespace sim2d
