#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/map/NavigationMap.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/world/Registry.h"
#include "sim2d/world/Sensing.h"

namespace sim2d {

/// What a robot knows when it decides; the world as it was when the step began.
struct Observation {
  Pose2 pose;
  double linear = 0.0, angular = 0.0;  // own motion [m/s], [rad/s]
  Vec2 goal = Vec2::Zero();            // the current one
  double goalRadius = 0.2;             // [m]
  double bodyRadius = 0.35;            // of the circle round the robot [m]
  double time = 0.0, dt = 0.05;        // [s]
  std::vector<SeenBody> bodies;        // people and other robots, by id; also hidden ones
  const Obstacles* obstacles = nullptr;
  const NavigationMap* navigation = nullptr;
};

/// A local planner of one robot. The world limits speeds and accelerations to the robot's own.
class RobotController {
 public:
  virtual ~RobotController() = default;
  virtual base::Twist2 command(const Observation& observation) = 0;
  /// What it follows now, for display; the robot's place first.
  virtual std::vector<Vec2> path() const { return {}; }
  /// It planned anew, or does not get on, since the last call.
  virtual bool takeReplanned() { return false; }
};

/// A planner of one robot; errors name the robot. A file in this folder registers its own in
/// `add<File>`.
using PlannerMaker =
    std::function<base::Result<std::shared_ptr<RobotController>>(const ResolvedRobot&)>;
using PlannerRegistry = Registry<PlannerMaker>;

}  // namespace sim2d
