#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2Block.h"

namespace sim2d::nav2 {

struct GoalQuery {
  Pose2 robot, goal;
  BodyTwist speed;                  // measured
  double pathLength = 0.0;          // of the local path [m]; main only
  const Path* localPath = nullptr;  // null: before main, or not known
};

/// Whether the robot stands where and how it should (nav2_core::GoalChecker).
class GoalChecker {
 public:
  virtual ~GoalChecker() = default;
  virtual void reset() = 0;
  virtual bool isGoalReached(const GoalQuery& query) = 0;
  /// Whether the place alone is reached, or was since the last reset. What main's controllers ask.
  virtual bool isXyReached(const GoalQuery& query) = 0;
  virtual double xyTolerance() const = 0;   // [m]
  virtual double yawTolerance() const = 0;  // [rad]
};

struct GoalCheckerParameters {
  double xyTolerance = 0.25;           // [m]
  double yawTolerance = 0.25;          // [rad]
  bool isStateful = true;              // the place is latched until the next reset
  bool isSymmetric = false;            // backwards is as good
  double pathLengthTolerance = 1.0;    // [m], main
  double rotStoppedVelocity = 0.25;    // [rad/s], StoppedGoalChecker
  double transStoppedVelocity = 0.25;  // [m/s], StoppedGoalChecker
};
const std::vector<Nav2Key<GoalCheckerParameters>>& goalCheckerKeys();
const std::vector<IdleKey>& goalCheckerIdleKeys();
/// The keys that the class of a plugin reads; all of them for an unknown class.
Nav2Keys goalCheckerKeysOf(const std::string& plugin);

/// By its plugin, "nav2_controller::SimpleGoalChecker" and so on; an error tells what comes
/// nearest.
base::Result<std::unique_ptr<GoalChecker>> makeGoalChecker(const std::string& plugin, Distro distro,
                                                           const Nav2Block& block);
std::vector<std::string> goalCheckerPlugins(Distro distro);

}  // namespace sim2d::nav2
