#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

namespace sim2d::nav2 {

struct GoalQuery {
  Pose2 robot, goal;
  BodyTwist speed;                  // measured
  double pathLength = 0.0;          // of the local path [m]; main only
  const Path* localPath = nullptr;  // null: before main, or unknown
};

/// Checks whether the robot has reached the goal (nav2_core::GoalChecker).
class GoalChecker {
 public:
  virtual ~GoalChecker() = default;
  virtual void reset() = 0;
  virtual bool isGoalReached(const GoalQuery& query) = 0;
  /// Whether the position is reached, or was since the last reset. Used by main's controllers.
  virtual bool isXyReached(const GoalQuery& query) = 0;
  virtual double xyTolerance() const = 0;   // [m]
  virtual double yawTolerance() const = 0;  // [rad]
};

struct GoalCheckerParameters {
  double xyTolerance = 0.25;           // [m]
  double yawTolerance = 0.25;          // [rad]
  bool isStateful = true;              // the position is latched until the next reset
  bool isSymmetric = false;            // the opposite heading is accepted
  double pathLengthTolerance = 1.0;    // [m], main
  double rotStoppedVelocity = 0.25;    // [rad/s], StoppedGoalChecker
  double transStoppedVelocity = 0.25;  // [m/s], StoppedGoalChecker
};
/// The keys that the class reads; all keys for an unknown class.
Nav2KeyTable goalCheckerKeysOf(const std::string& plugin);

/// Creates a checker by its plugin ("nav2_controller::SimpleGoalChecker" …). The error for an
/// unknown plugin contains the nearest name.
base::Result<std::unique_ptr<GoalChecker>> makeGoalChecker(const std::string& plugin, Distro distro,
                                                           const Nav2ParameterBlock& block);
std::vector<std::string> goalCheckerPlugins();

/// Goal checkers that Nav2 has since Lyrical: one with tolerances along and across the path, and
/// one with a fine and a coarse tolerance, of which the latter applies to a stagnant robot.

/// Keys of nav2_controller::AxisGoalChecker, which splits the robot's offset from the goal into
/// components along and across the end of the local path (direction from a pose at least
/// `directionDistance` before the goal; before main from the second to last pose). Both components
/// must be below their tolerances. With `isOvershootValid` a robot beyond the goal is within the
/// tolerance along the path. With fewer than two poses the goal's heading is the direction.
struct AxisGoalParameters {
  double alongTolerance = 0.25;      // [m]
  double acrossTolerance = 0.25;     // [m]
  double pathLengthTolerance = 1.0;  // [m]
  double directionDistance = 0.15;   // [m], main
  bool isOvershootValid = false;
};

/// Keys of nav2_controller::AdaptiveToleranceGoalChecker: the position is reached within the fine
/// tolerance, or within the coarse one once the robot has been stopped there (both stopped
/// velocities) for `stagnationCycles` consecutive checks.
struct AdaptiveGoalParameters {
  double fineTolerance = 0.10;         // [m]
  double coarseTolerance = 0.25;       // [m]
  double yawTolerance = 0.25;          // [rad]
  double pathLengthTolerance = 1.0;    // [m]
  double rotStoppedVelocity = 0.10;    // [rad/s]
  double transStoppedVelocity = 0.10;  // [m/s]
  int stagnationCycles = 15;           // consecutive checks
  bool isStateful = true;              // the position is latched until the next reset
  bool isSymmetric = false;            // the opposite heading is accepted
};

struct ProgressCheckerParameters {
  double movementRadius = 0.5;          // [m]
  double movementAngle = 0.5;           // [rad], PoseProgressChecker
  double movementTimeAllowance = 10.0;  // [s]
};
const std::vector<Nav2Key<ProgressCheckerParameters>>& progressCheckerKeys();

/// Checks whether the robot makes progress: nav2_controller::SimpleProgressChecker, and
/// PoseProgressChecker, for which rotation counts as well.
class ProgressChecker {
 public:
  enum class Kind { Simple, Pose };
  ProgressChecker(Kind kind, const ProgressCheckerParameters& parameters)
      : kind_(kind), parameters_(parameters) {}

  void reset() { baseline_.reset(); }
  /// False if the robot has stayed within the movement radius longer than allowed. `time` [s].
  bool check(const Pose2& robot, double time);

 private:
  bool hasMoved(const Pose2& robot) const;

  Kind kind_;
  ProgressCheckerParameters parameters_;
  std::optional<Pose2> baseline_;
  double baselineTime_ = 0.0;  // [s]
};

base::Result<std::unique_ptr<ProgressChecker>> makeProgressChecker(const std::string& plugin,
                                                                   Distro distro,
                                                                   const Nav2ParameterBlock& block);
std::vector<std::string> progressCheckerPlugins();

}  // namespace sim2d::nav2
