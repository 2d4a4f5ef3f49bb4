#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/world/Sensing.h"
#include "sim2d/world/Ways.h"

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
  Ways* ways = nullptr;
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

/// The planners by name. A file in this folder registers its own in `add<File>`.
class PlannerRegistry {
 public:
  /// Unknown names among the parameters are the maker's to report.
  using Maker = std::function<base::Result<std::shared_ptr<RobotController>>(const ResolvedRobot&)>;

  void add(std::string name, Maker maker) {
    entries_.push_back({std::move(name), std::move(maker)});
  }
  std::vector<std::string> names() const;
  base::Result<std::shared_ptr<RobotController>> make(const ResolvedRobot& robot) const;

 private:
  struct Entry {
    std::string name;
    Maker maker;
  };
  std::vector<Entry> entries_;
};

/// All planners of this program.
const PlannerRegistry& robotPlanners();

}  // namespace sim2d
