#include "sim2d/nav/nav2/control/RotationShimController.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/control/ControllerUtils.h"
#include "sim2d/nav/nav2/control/PathHandler.h"

namespace sim2d::nav2 {
namespace {

constexpr char kRotationShimPlugin[] = "nav2_rotation_shim_controller::RotationShimController";
constexpr char kPrimaryPrefix[] = "primary_controller.";

/// The values for the primary controller: its keys are beside the shim's, in main also below
/// `primary_controller`.
Nav2ParameterBlock primaryBlock(const Nav2ParameterBlock& block, Distro distro) {
  Nav2ParameterBlock inner = block;
  const std::string prefix = kPrimaryPrefix;
  for (const auto& [key, value] : block) {
    if (distro >= Distro::Lyrical && base::startsWith(key, prefix)) {
      inner[key.substr(prefix.size())] = value;
    }
  }
  return inner;
}

RotationShimParameters rotationShimParameters(const Nav2ParameterBlock& block, Distro distro,
                                              base::Diagnostics& problems) {
  return applyBlock(rotationShimDefaults(distro), rotationShimKeys(), block, distro, problems);
}

base::Result<std::unique_ptr<Controller>> makeShim(const ControllerSetup& setup) {
  base::Diagnostics problems;
  const auto parameters = rotationShimParameters(setup.block, setup.distro, problems);
  if (normalizedPluginClass(parameters.primary) == kRotationShimPlugin) {
    problems.push_back(base::error(
        "nav2.wrong-value",
        {"primary_controller", "'" + parameters.primary + "'", "a different controller"}));
    return problems;
  }
  if (parameters.primary.empty()) {
    problems.push_back(base::error("nav2.missing-key", {"primary_controller"}));
    return problems;
  }
  constexpr double kMaxTurnDuration = 100.0;  // [s]
  ParameterChecks(problems).within("simulate_ahead_time", parameters.simulateAheadTime,
                                   {-HUGE_VAL, kMaxTurnDuration}, "up to 100 s");
  ControllerSetup inner = setup;
  inner.block = primaryBlock(setup.block, setup.distro);
  auto primary = makeController(parameters.primary, inner);
  base::append(problems, primary.diagnostics());
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::make_unique<RotationShimController>(parameters, setup.distro, setup.frequency,
                                                   *std::move(primary)),
          std::move(problems)};
}

Nav2KeyTable rotationShimKeysOf(const Nav2ParameterBlock& given, Distro distro) {
  Nav2KeyTable keys =
      keyTableOf(rotationShimKeys(), rotationShimDefaults(distro), ignoredRotationShimKeys());
  base::Diagnostics ignored;  // reported by makeShim
  const std::string primary = rotationShimParameters(given, distro, ignored).primary;
  const ControllerType* type = findController(primary);
  if (type == nullptr || type->plugin == kRotationShimPlugin) {
    return keys;
  }
  const Nav2KeyTable inner = type->keys(primaryBlock(given, distro), distro);
  for (Nav2KeyTable::Row row : inner.rows) {
    if (keys.find(row.name, distro) == nullptr) {
      keys.rows.push_back(row);
    }
    if (distro >= Distro::Lyrical) {
      row.name.insert(0, kPrimaryPrefix);
      keys.rows.push_back(std::move(row));
    }
  }
  keys.ignored.insert(keys.ignored.end(), inner.ignored.begin(), inner.ignored.end());
  return keys;
}

}  // namespace

RotationShimParameters rotationShimDefaults(Distro distro) {
  RotationShimParameters parameters;
  if (distro == Distro::Humble) {
    parameters.disengageThreshold = 0.785;
  }
  return parameters;
}

const std::vector<Nav2Key<RotationShimParameters>>& rotationShimKeys() {
  using P = RotationShimParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"primary_controller", &P::primary, "", "plugin of the primary controller", kUntilKilted},
      {"primary_controller.plugin", &P::primary, "", "plugin of the primary controller",
       kSinceLyrical},
      {"angular_dist_threshold", &P::threshold, "rad",
       "angle to the path above which the robot rotates first"},
      {"angular_disengage_threshold", &P::disengageThreshold, "rad",
       "angle below which the rotation ends"},
      {"forward_sampling_distance", &P::samplingDistance, "m",
       "distance along the path of the point that determines the direction"},
      {"rotate_to_heading_angular_vel", &P::rotateVelocity, "rad/s", "turn rate of the rotation"},
      {"max_angular_accel", &P::maxAngularAcceleration, "rad/s^2", "maximum angular acceleration"},
      {"simulate_ahead_time", &P::simulateAheadTime, "s",
       "time for which a rotation is simulated ahead"},
      {"rotate_to_goal_heading", &P::rotatesToGoal, "", "rotates to the goal's heading itself"},
      {"closed_loop", &P::isClosedLoop, "", "uses the measured velocity, not the last command"},
      {"rotate_to_heading_once", &P::rotatesOnce, "",
       "rotates only for new goals, not for new paths", kSinceJazzy},
      {"use_path_orientations", &P::usesPathOrientations, "",
       "the direction is the heading of the pose at that point", kSinceJazzy},
      {"max_cost_threshold", &P::maxCost, "",
       "minimum cost that counts as a collision during the rotation", kJazzy | kSinceLyrical},
  };
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredRotationShimKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"transform_tolerance", "TF is not used"},
  };
  return kKeys;
}

RotationShimController::RotationShimController(const RotationShimParameters& parameters,
                                               Distro distro, double frequency,
                                               std::unique_ptr<Controller> primary)
    : parameters_(parameters),
      distro_(distro),
      period_(1.0 / frequency),
      primary_(std::move(primary)) {}

void RotationShimController::setPlan(const Path& plan) {
  const bool isGoalNew = isTurning_ || plan_.empty() || plan.empty() || plan.back() != plan_.back();
  isPathNew_ = !parameters_.rotatesOnce || isGoalNew;
  plan_ = plan;
  primary_->setPlan(plan);
}

void RotationShimController::setSpeedLimit(double limit, bool isPercentage) {
  primary_->setSpeedLimit(limit, isPercentage);
}

void RotationShimController::reset() {
  lastAngular_.reset();
  primary_->reset();
}

ControlResult RotationShimController::computeVelocityCommands(const ControlInput& input) {
  if (parameters_.rotatesToGoal) {
    if (const std::optional<double> angle = goalTurn(input)) {
      if (const std::optional<BodyTwist> command = turn(input, *angle)) {
        return *command;
      }
    }
  }
  const bool isEachCycle = distro_ >= Distro::Lyrical && !parameters_.rotatesOnce;
  if (isPathNew_ || isEachCycle) {
    const std::optional<double> angle = pathTurn(input);
    const double threshold = isTurning_ ? parameters_.disengageThreshold : parameters_.threshold;
    if (angle && std::abs(*angle) > threshold) {
      isTurning_ = true;
      if (const std::optional<BodyTwist> command = turn(input, *angle)) {
        return *command;
      }
    }
    isPathNew_ = false;
  }
  return drive(input);
}

ControlResult RotationShimController::drive(const ControlInput& input) {
  isTurning_ = false;
  primary_->watch(isWatched());
  ControlResult control = primary_->computeVelocityCommands(input);
  view_ = primary_->view();
  if (control) {
    lastAngular_ = control.twist.angular;
  }
  return control;
}

/// The rotation to the goal's heading, once its position is reached [rad].
std::optional<double> RotationShimController::goalTurn(const ControlInput& input) const {
  if (plan_.empty()) {
    return std::nullopt;
  }
  const Pose2 goal = input.fromPlan(plan_.back());
  const double tolerance = input.goalChecker.xyTolerance();
  bool isThere = (input.robot.position - goal.position).squaredNorm() <= tolerance * tolerance;
  if (distro_ >= Distro::Lyrical && input.localPlan != nullptr) {
    isThere = input.goalChecker.isXyReached(
        {input.robot, goal, input.speed, pathLength(*input.localPlan), input.localPlan});
  }
  return isThere ? std::optional(base::angleDiff(goal.heading, input.robot.heading)) : std::nullopt;
}

/// The rotation to the first pose at the sampling distance [rad]; nullopt for fewer than two poses.
std::optional<double> RotationShimController::pathTurn(const ControlInput& input) const {
  const bool isLocal = distro_ >= Distro::Lyrical && input.localPlan != nullptr;
  const Path& path = isLocal ? *input.localPlan : plan_;
  if (path.size() < 2) {
    return std::nullopt;
  }
  const auto far = std::find_if(path.begin() + 1, path.end(), [&](const Pose2& each) {
    return (each.position - path.front().position).norm() >= parameters_.samplingDistance;
  });
  const Pose2& pose = far == path.end() ? path.back() : *far;
  const Pose2 sampled = isLocal ? pose : input.fromPlan(pose);
  return parameters_.usesPathOrientations ? base::angleDiff(sampled.heading, input.robot.heading)
                                          : base::headingOf(input.robot.toLocal(sampled.position));
}

/// The command of a rotation; nullopt if it collides.
std::optional<BodyTwist> RotationShimController::turn(const ControlInput& input, double angle) {
  const double now =
      parameters_.isClosedLoop ? input.speed.angular : lastAngular_.value_or(input.speed.angular);
  const double w = rotationVelocity(
      {parameters_.rotateVelocity, parameters_.maxAngularAcceleration}, angle, now, period_);
  view_ = {};
  Pose2 pose = input.robot;
  double time = 0.0;
  while (time < parameters_.simulateAheadTime) {
    time += period_;
    pose.heading = input.robot.heading + w * time;
    // As in Nav2 rotations to the right are simulated until the primary controller takes over,
    // those to the left for the whole time.
    if (base::angleDiff(input.robot.heading, pose.heading) >=
        std::abs(angle) - parameters_.threshold) {
      break;
    }
    view_.predicted.push_back(pose);
    if (footprintCost(input.costmap, input.shape.vertices, pose) >= parameters_.maxCost) {
      return std::nullopt;
    }
  }
  lastAngular_ = w;
  return BodyTwist{0.0, w};
}

ControllerType rotationShim() {
  return {kRotationShimPlugin, rotationShimKeysOf, makeShim};
}

}  // namespace sim2d::nav2
