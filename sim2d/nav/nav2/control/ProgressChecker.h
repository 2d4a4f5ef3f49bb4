#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

namespace sim2d::nav2 {

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
std::vector<std::string> progressCheckerPlugins(Distro distro);

}  // namespace sim2d::nav2
