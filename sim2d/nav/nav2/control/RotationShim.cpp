#include "sim2d/nav/nav2/control/RotationShim.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/control/HeadingTurn.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/control/PoseCollision.h"

namespace sim2d::nav2 {
namespace {

constexpr char kShimPlugin[] = "nav2_rotation_shim_controller::RotationShimController";
constexpr char kPrimaryPrefix[] = "primary_controller.";

/// What is given for the primary controller: its keys lie beside the shim's, in main also below
/// `primary_controller`.
Nav2Block primaryBlock(const Nav2Block& block, Distro distro) {
  Nav2Block inner = block;
  const std::string prefix = kPrimaryPrefix;
  for (const auto& [key, value] : block) {
    if (distro >= Distro::Lyrical && key.compare(0, prefix.size(), prefix) == 0) {
      inner[key.substr(prefix.size())] = value;
    }
  }
  return inner;
}

RotationShimParameters shimParameters(const Nav2Block& block, Distro distro,
                                      base::Diagnostics& problems) {
  return filled(rotationShimDefaults(distro), rotationShimKeys(), block, distro, problems);
}

base::Result<std::unique_ptr<Controller>> makeShim(const ControllerSetup& setup) {
  base::Diagnostics problems;
  const auto parameters = shimParameters(setup.block, setup.distro, problems);
  if (pluginName(parameters.primary) == kShimPlugin) {
    problems.push_back(base::error(
        "nav2.wrong-value", {"primary_controller", "'" + parameters.primary + "'", "another one"}));
    return problems;
  }
  if (parameters.primary.empty()) {
    problems.push_back(base::error("nav2.missing-key", {"primary_controller"}));
    return problems;
  }
  constexpr double kLongestTurn = 100.0;  // [s]
  if (!(parameters.simulateAheadTime <= kLongestTurn)) {
    problems.push_back(base::error(
        "nav2.wrong-value", {"simulate_ahead_time", parameters.simulateAheadTime, "up to 100 s"}));
  }
  ControllerSetup inner = setup;
  inner.block = primaryBlock(setup.block, setup.distro);
  auto primary = controllerRegistry().make(parameters.primary, inner);
  base::append(problems, primary.diagnostics());
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::make_unique<RotationShim>(parameters, setup.distro, setup.frequency,
                                         *std::move(primary)),
          std::move(problems)};
}

Nav2Keys shimKeysOf(const Nav2Block& given, Distro distro) {
  Nav2Keys keys;
  addRows(keys, rotationShimKeys(), rotationShimDefaults(distro));
  addIdle(keys, rotationShimIdleKeys());
  base::Diagnostics ignored;  // the maker tells them
  const std::string primary = shimParameters(given, distro, ignored).primary;
  const ControllerType* type = controllerRegistry().find(primary, distro);
  if (type == nullptr || type->plugin == kShimPlugin) {
    return keys;
  }
  const Nav2Keys inner = type->keys(primaryBlock(given, distro), distro);
  for (Nav2Keys::Row row : inner.rows) {
    if (keys.find(row.name, distro) == nullptr) {
      keys.rows.push_back(row);
    }
    if (distro >= Distro::Lyrical) {
      row.name.insert(0, kPrimaryPrefix);
      keys.rows.push_back(std::move(row));
    }
  }
  keys.idle.insert(keys.idle.end(), inner.idle.begin(), inner.idle.end());
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
      {"primary_controller", &P::primary, "", "plugin of the controller that drives", kUntilKilted},
      {"primary_controller.plugin", &P::primary, "", "plugin of the controller that drives",
       kSinceLyrical},
      {"angular_dist_threshold", &P::threshold, "rad", "larger angles are turned first"},
      {"angular_disengage_threshold", &P::disengageThreshold, "rad",
       "turning ends below this angle"},
      {"forward_sampling_distance", &P::samplingDistance, "m",
       "so far on the path it looks for the direction"},
      {"rotate_to_heading_angular_vel", &P::rotateVelocity, "rad/s", "how fast it turns"},
      {"max_angular_accel", &P::maxAngularAcceleration, "rad/s^2", "how fast turning changes"},
      {"simulate_ahead_time", &P::simulateAheadTime, "s", "so long a turn is looked ahead"},
      {"rotate_to_goal_heading", &P::rotatesToGoal, "", "turns to the goal's heading itself"},
      {"closed_loop", &P::isClosedLoop, "", "goes by the measured velocity, not by the last sent"},
      {"rotate_to_heading_once", &P::rotatesOnce, "", "for new goals, not for new paths",
       kSinceJazzy},
      {"use_path_orientations", &P::usesPathOrientations, "",
       "the direction is the heading of the pose there", kSinceJazzy},
      {"max_cost_threshold", &P::maxCost, "", "from this cost on a turn collides",
       kJazzy | kSinceLyrical},
  };
  return kKeys;
}

const std::vector<IdleKey>& rotationShimIdleKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"transform_tolerance", "no TF here"},
  };
  return kKeys;
}

RotationShim::RotationShim(const RotationShimParameters& parameters, Distro distro,
                           double frequency, std::unique_ptr<Controller> primary)
    : parameters_(parameters),
      distro_(distro),
      period_(1.0 / frequency),
      primary_(std::move(primary)) {}

void RotationShim::setPlan(const Path& plan) {
  const bool isGoalNew = isTurning_ || plan_.empty() || plan.empty() || plan.back() != plan_.back();
  isPathNew_ = !parameters_.rotatesOnce || isGoalNew;
  plan_ = plan;
  primary_->setPlan(plan);
}

void RotationShim::setSpeedLimit(double limit, bool isPercentage) {
  primary_->setSpeedLimit(limit, isPercentage);
}

void RotationShim::reset() {
  lastAngular_.reset();
  primary_->reset();
}

Control RotationShim::computeVelocityCommands(const ControlInput& input) {
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

Control RotationShim::drive(const ControlInput& input) {
  isTurning_ = false;
  primary_->watch(isWatched());
  Control control = primary_->computeVelocityCommands(input);
  view_ = primary_->view();
  if (control) {
    lastAngular_ = control.twist.angular;
  }
  return control;
}

/// To the goal's heading, once its place is reached [rad].
std::optional<double> RotationShim::goalTurn(const ControlInput& input) const {
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

/// To the first pose so far from the path's start [rad]; none on a path of less than two poses.
std::optional<double> RotationShim::pathTurn(const ControlInput& input) const {
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

/// The command of a turn; none when its sweep collides.
std::optional<BodyTwist> RotationShim::turn(const ControlInput& input, double angle) {
  const double now =
      parameters_.isClosedLoop ? input.speed.angular : lastAngular_.value_or(input.speed.angular);
  const double w = turnVelocity({parameters_.rotateVelocity, parameters_.maxAngularAcceleration},
                                angle, now, period_);
  view_ = {};
  Pose2 pose = input.robot;
  double time = 0.0;
  while (time < parameters_.simulateAheadTime) {
    time += period_;
    pose.heading = input.robot.heading + w * time;
    // As in Nav2: turns to the right are looked ahead until the primary controller takes over,
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

void addRotationShim(ControllerRegistry& registry) {
  ControllerType type;
  type.plugin = kShimPlugin;
  type.help = "Turns on the spot towards a new path, then lets another controller drive.";
  type.keys = shimKeysOf;
  type.make = makeShim;
  registry.add(std::move(type));
}

}  // namespace sim2d::nav2
