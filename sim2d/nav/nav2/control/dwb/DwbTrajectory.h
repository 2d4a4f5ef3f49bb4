#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/control/dwb/DwbParameters.h"

/// How a command would go on (dwb_plugins: standard_traj_generator.cpp,
/// limited_accel_generator.cpp).
namespace sim2d::nav2 {

struct DwbTrajectory {
  BodyTwist velocity;        // the command it stands for
  std::vector<Pose2> poses;  // the robot's first, the last twice with include_last_point
  std::vector<int> cells;    // of each pose: index in the costmap, -1 off it
  std::size_t onMap = 0;     // poses before the first off the map
  double step = 0.0;         // [s] between poses

  /// Where it is after `time` [s], in between straight.
  Pose2 at(double time) const;
};

/// Poses between the first and the end of a command.
int stepCount(const DwbParameters& parameters, const BodyTwist& command);

/// Makes trajectories of one cycle; buffers are kept.
class TrajectoryGenerator {
 public:
  enum class Kind { Standard, LimitedAccel };
  TrajectoryGenerator(Kind kind, double frequency);

  /// A cycle from here on. The costmap must live through it.
  void start(const DwbParameters& parameters, const Pose2& robot, const BodyTwist& speed,
             const Costmap& costmap);
  const std::vector<BodyTwist>& commands() const { return commands_; }
  void generate(const BodyTwist& command, DwbTrajectory& trajectory);

 private:
  struct Step {
    double heading;   // [rad] after it
    double sin, cos;  // of the heading before it
  };
  /// Headings depend on the angular command and the number of steps alone: they are kept.
  struct Turning {
    double angular = 0.0;  // [rad/s]
    std::vector<Step> steps;
  };
  const std::vector<Step>& turning(double angular, int count);
  BodyTwist next(const BodyTwist& velocity, const BodyTwist& command, double dt) const;

  Kind kind_;
  double period_;  // [s] of the controller
  const DwbParameters* parameters_ = nullptr;
  const Costmap* costmap_ = nullptr;
  Pose2 robot_;
  BodyTwist speed_;
  std::vector<BodyTwist> commands_;
  std::vector<Turning> turnings_;  // those of this cycle come first
  std::size_t turningCount_ = 0;
  std::size_t lastTurning_ = 0;
};

}  // namespace sim2d::nav2
