#include "sim2d/nav/nav2/control/ProgressChecker.h"

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"

namespace sim2d::nav2 {
namespace {

struct ProgressCheckerType {
  const char* plugin;
  ProgressChecker::Kind kind;
  unsigned distros;
};
constexpr ProgressCheckerType kProgressCheckers[] = {
    {"nav2_controller::SimpleProgressChecker", ProgressChecker::Kind::Simple, kAllDistros},
    {"nav2_controller::PoseProgressChecker", ProgressChecker::Kind::Pose, kAllDistros},
};

}  // namespace

bool ProgressChecker::check(const Pose2& robot, double time) {
  if (!baseline_ || hasMoved(robot)) {
    baseline_ = robot;
    baselineTime_ = time;
    return true;
  }
  return time - baselineTime_ <= parameters_.movementTimeAllowance;
}

bool ProgressChecker::hasMoved(const Pose2& robot) const {
  if ((robot.position - baseline_->position).norm() > parameters_.movementRadius) {
    return true;
  }
  return kind_ == Kind::Pose &&
         std::abs(base::angleDiff(robot.heading, baseline_->heading)) > parameters_.movementAngle;
}

const std::vector<Nav2Key<ProgressCheckerParameters>>& progressCheckerKeys() {
  using P = ProgressCheckerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"required_movement_radius", &P::movementRadius, "m",
       "radius that the robot must leave to make progress"},
      {"required_movement_angle", &P::movementAngle, "rad",
       "a rotation by more than this is progress too (PoseProgressChecker)"},
      {"movement_time_allowance", &P::movementTimeAllowance, "s",
       "maximum time without progress; longer is a failure"},
  };
  return kKeys;
}

std::vector<std::string> progressCheckerPlugins(Distro distro) {
  std::vector<std::string> names;
  for (const ProgressCheckerType& type : kProgressCheckers) {
    if (includesDistro(type.distros, distro)) {
      names.emplace_back(type.plugin);
    }
  }
  return names;
}

base::Result<std::unique_ptr<ProgressChecker>> makeProgressChecker(
    const std::string& plugin, Distro distro, const Nav2ParameterBlock& block) {
  for (const ProgressCheckerType& type : kProgressCheckers) {
    if (normalizedPluginClass(plugin) != type.plugin || !includesDistro(type.distros, distro)) {
      continue;
    }
    base::Diagnostics problems;
    const auto parameters =
        applyBlock(ProgressCheckerParameters(), progressCheckerKeys(), block, distro, problems);
    if (base::hasErrors(problems)) {
      return problems;
    }
    return {std::make_unique<ProgressChecker>(type.kind, parameters), std::move(problems)};
  }
  return unknownPlugin(plugin, progressCheckerPlugins(distro));
}

}  // namespace sim2d::nav2
