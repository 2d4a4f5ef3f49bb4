#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/control/GoalChecker.h"

/// Goal checkers that Nav2 has since Lyrical: one with tolerances along and across the path, one
/// with two tolerances of which the greater counts for a robot that does not get on.
namespace sim2d::nav2 {

/// Keys of nav2_controller::AxisGoalChecker.
struct AxisGoalParameters {
  double alongTolerance = 0.25;      // [m]
  double acrossTolerance = 0.25;     // [m]
  double pathLengthTolerance = 1.0;  // [m]
  double directionDistance = 0.15;   // [m], main
  bool isOvershootValid = false;
};
const std::vector<Nav2Key<AxisGoalParameters>>& axisGoalKeys();

/// Keys of nav2_controller::AdaptiveToleranceGoalChecker.
struct AdaptiveGoalParameters {
  double fineTolerance = 0.10;         // [m]
  double coarseTolerance = 0.25;       // [m]
  double yawTolerance = 0.25;          // [rad]
  double pathLengthTolerance = 1.0;    // [m]
  double rotStoppedVelocity = 0.10;    // [rad/s]
  double transStoppedVelocity = 0.10;  // [m/s]
  int stagnationCycles = 15;           // checks in a row
  bool isStateful = true;              // the place is latched until the next reset
  bool isSymmetric = false;            // backwards is as good
};
const std::vector<Nav2Key<AdaptiveGoalParameters>>& adaptiveGoalKeys();

/// The robot's offset from the goal is split along the last stretch of the local path (a pose at
/// least `directionDistance` before the goal; before main the last pose but one) and across it;
/// both parts must be below their tolerances. With `isOvershootValid` a robot beyond the goal is
/// within the tolerance along the path. Without two poses the path's direction is the goal's
/// heading.
std::unique_ptr<GoalChecker> makeAxisGoalChecker(const AxisGoalParameters& parameters,
                                                 Distro distro);

/// The place is reached within the fine tolerance, or within the coarse one once the robot has
/// stood there (both stopped velocities) for `stagnationCycles` checks in a row.
std::unique_ptr<GoalChecker> makeAdaptiveGoalChecker(const AdaptiveGoalParameters& parameters);

}  // namespace sim2d::nav2
