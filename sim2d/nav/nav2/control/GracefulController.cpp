#include "sim2d/nav/nav2/control/GracefulController.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/PoseCollision.h"
#include "sim2d/nav/nav2/control/PursuitRules.h"
#include "sim2d/nav/nav2/control/SmoothControlLaw.h"

namespace sim2d::nav2 {
namespace {

constexpr char kGracefulCollision[] = "Collision detected in trajectory";

/// Planners without headings give all the same one: then poses point at the next.
void addHeadings(Path& path) {
  constexpr double kSame = 1e-6;  // [rad]
  if (path.size() < 3) {
    return;
  }
  for (std::size_t i = 2; i + 1 < path.size(); ++i) {
    if (std::abs(base::angleDiff(path[i].heading, path[1].heading)) > kSame) {
      return;
    }
  }
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    path[i].heading = base::headingOf(path[i + 1].position - path[i].position);
  }
}

/// Along the path to each of its poses [m], from the robot on.
std::vector<double> waysTo(const Path& plan) {
  std::vector<double> ways;
  double way = plan.front().position.norm();
  for (std::size_t i = 0; i < plan.size(); ++i) {
    way += i > 0 ? (plan[i].position - plan[i - 1].position).norm() : 0.0;
    ways.push_back(way);
  }
  return ways;
}

PathHandling gracefulHandling(const GracefulParameters& parameters, Distro distro) {
  PathHandling handling;
  handling.rule = PathHandling::Rule::Pursuit;
  handling.searchDistance = parameters.searchDistance;
  handling.keepsTwo = distro != Distro::Humble;
  return handling;
}

base::Result<std::unique_ptr<Controller>> makeGraceful(const ControllerSetup& setup) {
  base::Diagnostics problems;
  const auto parameters =
      filled(gracefulDefaults(setup.distro), gracefulKeys(), setup.block, setup.distro, problems);
  const std::pair<const char*, double> positive[] = {
      {"slowdown_radius", parameters.slowdownRadius},
      {"v_linear_max", parameters.maxLinear},
      {"in_place_collision_resolution", parameters.inPlaceResolution},
      {"footprint_scaling_step", parameters.footprintScalingStep}};
  for (const auto& [key, value] : positive) {
    if (!(value > 0.0)) {
      problems.push_back(base::error("nav2.wrong-value", {key, value, "above 0"}));
    }
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::make_unique<GracefulController>(parameters, setup.distro), std::move(problems)};
}

}  // namespace

GracefulController::GracefulController(const GracefulParameters& parameters, Distro distro)
    : parameters_(parameters),
      fullParameters_(parameters),
      distro_(distro),
      handler_(gracefulHandling(parameters, distro)) {}

void GracefulController::setPlan(const Path& plan) {
  handler_.setPlan(plan);
  goal_ = plan.empty() ? Pose2() : plan.back();
  isGoalReached_ = false;
  turnsFirst_ = true;
}

void GracefulController::setSpeedLimit(double limit, bool isPercentage) {
  const GracefulParameters& full = fullParameters_;
  if (limit == 0.0) {
    parameters_.maxLinear = full.maxLinear;
    parameters_.maxAngular = full.maxAngular;
    return;
  }
  const double ratio = isPercentage ? limit / 100.0 : limit / full.maxLinear;
  parameters_.maxLinear = std::max(isPercentage ? full.maxLinear * ratio : limit, full.minLinear);
  parameters_.maxAngular = full.maxAngular * ratio;
}

Control GracefulController::computeVelocityCommands(const ControlInput& input) {
  LocalPlan local = handler_.localPlan(input);
  view_ = {};
  if (local.problem != nullptr) {
    return {ControlCode::InvalidPath, local.problem};
  }
  view_.localPlan = local.poses;
  const RobotFrame frame(input.robot);
  for (Pose2& pose : local.poses) {
    pose = frame.toLocal(pose);
  }
  addHeadings(local.poses);
  const double length = pathLength(local.poses);
  const Scene scene{input, std::move(local.poses), length};
  if (distro_ == Distro::Humble) {
    return followOneTarget(scene);
  }
  const double goalTurn = scene.plan.back().heading;
  if (isGoalTurn(scene) && turnIsFree(input, goalTurn)) {
    return BodyTwist{0.0, turnCommand(goalTurn)};
  }
  return distro_ >= Distro::Lyrical ? followInterpolated(scene) : followFarthest(scene);
}

bool GracefulController::isGoalTurn(const Scene& scene) {
  const ControlInput& input = scene.input;
  if (distro_ >= Distro::Lyrical) {
    return input.goalChecker.isXyReached(
        {input.robot, input.fromPlan(goal_), input.speed, scene.length, input.localPlan});
  }
  isGoalReached_ = isGoalReached_ || scene.length < input.goalChecker.xyTolerance();
  return isGoalReached_;
}

/// Humble: one target, at a fixed distance.
Control GracefulController::followOneTarget(const Scene& scene) {
  const ControlInput& input = scene.input;
  const auto far = std::find_if(scene.plan.begin(), scene.plan.end(), [&](const Pose2& pose) {
    return pose.position.norm() >= parameters_.targetDistance;
  });
  Pose2 target = far == scene.plan.end() ? scene.plan.back() : *far;
  const bool isBackward = parameters_.allowsBackward && target.position.x() < 0.0;
  if (isBackward) {
    target.heading = base::wrapToPi(target.heading + base::kPi);
  }
  view_.lookahead = {input.robot.toWorld(target.position)};
  turnsFirst_ = false;  // here it turns whenever the target lies aside
  BodyTwist command;
  if (collides(input, {}, 1.0) ||
      !simulate(input, {target, isBackward, parameters_.maxLinear}, command)) {
    return {ControlCode::NoValidControl, kGracefulCollision};
  }
  const double toTarget = base::headingOf(target.position);
  if (parameters_.prefersFinalRotation &&
      scene.plan.back().position.norm() < input.goalChecker.xyTolerance()) {
    command = {0.0, turnCommand(scene.plan.back().heading)};
  } else if (parameters_.rotatesFirst && std::abs(toTarget) > parameters_.firstRotationTolerance) {
    command = {0.0, turnCommand(toTarget)};
  }
  return command;
}

/// Jazzy: the farthest pose that can be reached.
Control GracefulController::followFarthest(const Scene& scene) {
  const std::vector<double> ways = waysTo(scene.plan);
  BodyTwist command;
  for (std::size_t i = scene.plan.size(); i-- > 0;) {
    if (ways[i] > parameters_.maxLookahead) {
      continue;
    }
    if (scene.length >= parameters_.maxLookahead && ways[i] < parameters_.minLookahead) {
      break;
    }
    if (drive(scene, scene.plan[i], command)) {
      return command;
    }
  }
  return {ControlCode::NoValidControl, kGracefulCollision};
}

/// Main: the point at the lookahead, then the poses before it.
Control GracefulController::followInterpolated(const Scene& scene) {
  const Path& plan = scene.plan;
  const double most = parameters_.maxLookahead;
  std::size_t next = 0;
  while (next < plan.size() && plan[next].position.norm() < most) {
    ++next;
  }
  Pose2 first = plan.back();
  if (next < plan.size()) {
    first = plan[next];
    if (next > 0) {
      first.position = carrotAt(plan, most, true, false);
      first.heading = base::headingOf(first.position - plan[next - 1].position);
    }
  }
  BodyTwist command;
  if (drive(scene, first, command)) {
    return command;
  }
  const std::vector<double> ways = waysTo(plan);
  for (std::size_t i = plan.size() - 1; i-- > 0;) {
    if (ways[i] <= most && drive(scene, plan[i], command)) {
      return command;
    }
  }
  return {ControlCode::NoValidControl, kGracefulCollision};
}

/// Tries a target, in main also more slowly; the footprint grows with the speed there.
bool GracefulController::drive(const Scene& scene, Pose2 target, BodyTwist& command) {
  if (scene.length < parameters_.maxLookahead && parameters_.prefersFinalRotation) {
    target.heading = base::headingOf(target.position);  // no sweeping turn at the end
  }
  const bool isBackward = parameters_.allowsBackward && target.position.x() < 0.0;
  if (isBackward) {
    target.heading = base::wrapToPi(target.heading + base::kPi);
  }
  view_.lookahead = {scene.input.robot.toWorld(target.position)};
  constexpr int kMostAttempts = 100;  // a step may be 0
  Attempt attempt{target, isBackward, parameters_.maxLinear};
  int attempts = 0;
  do {
    if (simulate(scene.input, attempt, command)) {
      return true;
    }
    attempt.maxLinear -= parameters_.footprintScalingStep;
  } while (distro_ >= Distro::Lyrical && attempt.maxLinear > 0.0 && ++attempts < kMostAttempts &&
           attempt.maxLinear >= parameters_.footprintScalingVelocity);
  return false;
}

/// Whether the first turn on the spot is over, or none is wanted.
bool GracefulController::isAhead(const Pose2& target) {
  if (std::abs(base::headingOf(target.position)) < parameters_.firstRotationTolerance) {
    turnsFirst_ = false;
  }
  return !turnsFirst_ || !parameters_.rotatesFirst;
}

/// Follows the law to the target; `command` is the first one. False: it would collide.
bool GracefulController::simulate(const ControlInput& input, const Attempt& attempt,
                                  BodyTwist& command) {
  GracefulParameters law = parameters_;
  law.maxLinear = attempt.maxLinear;
  const double resolution = input.costmap.resolution();
  const double dt = resolution / law.maxLinear;
  const double toTarget = base::headingOf(attempt.target.position);
  bool isTurning = !isAhead(attempt.target);
  double scale = 1.0;
  const double full = parameters_.maxLinear - parameters_.footprintScalingVelocity;
  if (distro_ >= Distro::Lyrical && full > 0.0) {
    const double above = law.maxLinear - parameters_.footprintScalingVelocity;
    scale += parameters_.footprintScalingFactor * std::max(0.0, above / full);
  }
  const double most = 3.0 * attempt.target.position.norm() / resolution;
  Path way;
  Pose2 pose;
  do {
    BodyTwist twist;
    if (isTurning) {
      const double left = toTarget - pose.heading;
      twist = way.empty() ? BodyTwist{0.0, turnCommand(left)} : command;
      isTurning = std::abs(left) >= law.firstRotationTolerance;
    } else {
      twist = gracefulCommand(law, distro_, attempt.target, pose, attempt.isBackward);
      pose.position += dt * twist.linear * pose.direction();
    }
    pose.heading = base::wrapToPi(pose.heading + dt * twist.angular);
    command = way.empty() ? twist : command;
    way.push_back({input.robot.toWorld(pose.position), input.robot.heading + pose.heading});
    if (collides(input, pose, scale)) {
      return false;
    }
  } while ((attempt.target.position - pose.position).norm() > resolution &&
           static_cast<double>(way.size()) < std::floor(most));
  view_.predicted = std::move(way);
  return true;
}

bool GracefulController::turnIsFree(const ControlInput& input, double angle) const {
  constexpr double kMostSteps = 1000.0;
  const double wanted = std::abs(angle) / parameters_.inPlaceResolution;
  const int steps = static_cast<int>(std::min(std::max(wanted, 1.0), kMostSteps));
  for (int i = 1; i <= steps; ++i) {
    if (collides(input, {Vec2::Zero(), static_cast<double>(i) / steps * angle}, 1.0)) {
      return false;
    }
  }
  return true;
}

bool GracefulController::collides(const ControlInput& input, const Pose2& local,
                                  double scale) const {
  if (distro_ >= Distro::Kilted && !parameters_.detectsCollisions) {
    return false;
  }
  const Pose2 pose{input.robot.toWorld(local.position), input.robot.heading + local.heading};
  const auto cell = input.costmap.worldToCell(pose.position);
  if (!cell) {
    return false;
  }
  const ControlledShape& shape = input.shape;
  if (shape.isRadius) {
    return isCentreCollision(input.costmap.at(*cell), shape.tracksUnknown);
  }
  if (scale == 1.0) {
    return isPoseInCollision(input, pose, OffMap::IsFree);
  }
  Polygon corners = shape.vertices;
  for (Vec2& corner : corners) {
    corner *= scale;
  }
  return isEdgeCollision(footprintCost(input.costmap, corners, pose), shape.tracksUnknown);
}

double GracefulController::turnCommand(double angle) const {
  const double w = parameters_.rotationScaling * angle * parameters_.maxAngular;
  const double least = distro_ == Distro::Humble ? 0.0 : parameters_.minAngularInPlace;
  return std::copysign(std::max(std::abs(w), least), w);
}

void addGraceful(ControllerRegistry& registry) {
  ControllerType type;
  type.plugin = "nav2_graceful_controller::GracefulController";
  type.help = "Drives smooth curves to targets on the path.";
  type.keys = [](const Nav2Block&, Distro distro) {
    Nav2Keys keys;
    addRows(keys, gracefulKeys(), gracefulDefaults(distro));
    addIdle(keys, gracefulIdleKeys());
    return keys;
  };
  type.make = makeGraceful;
  registry.add(std::move(type));
}

}  // namespace sim2d::nav2
