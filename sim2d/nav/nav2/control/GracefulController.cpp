#include "sim2d/nav/nav2/control/GracefulController.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/ControllerUtils.h"
#include "sim2d/nav/nav2/control/RegulationFunctions.h"

namespace sim2d::nav2 {

GracefulParameters gracefulDefaults(Distro distro) {
  GracefulParameters parameters;
  if (distro == Distro::Humble) {
    parameters.kPhi = 3.0;
    parameters.kDelta = 2.0;
    parameters.beta = 0.2;
  }
  return parameters;
}

const std::vector<Nav2Key<GracefulParameters>>& gracefulKeys() {
  using P = GracefulParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"k_phi", &P::kPhi, "",
       "control law: how early the robot turns towards the target's "
       "heading"},
      {"k_delta", &P::kDelta, "1/m", "control law: gain of the heading correction"},
      {"beta", &P::beta, "", "control law: amount of slowdown in curves"},
      {"lambda", &P::lambda, "", "control law: sharpness of that slowdown"},
      {"v_linear_min", &P::minLinear, "m/s", "minimum speed"},
      {"v_linear_max", &P::maxLinear, "m/s", "maximum speed"},
      {"v_angular_max", &P::maxAngular, "rad/s", "maximum turn rate"},
      {"v_angular_min_in_place", &P::minAngularInPlace, "rad/s",
       "minimum turn rate for rotation in place", kSinceJazzy},
      {"slowdown_radius", &P::slowdownRadius, "m",
       "distance to the target below which the robot slows down"},
      {"deceleration_max", &P::maxDeceleration, "m/s^2",
       "deceleration that limits the speed near the target", kSinceLyrical},
      {"max_robot_pose_search_dist", &P::searchDistance, "m",
       "length of the path that is searched for the robot; 0: half the costmap, negative: all",
       kUntilKilted},
      {"min_lookahead", &P::minLookahead, "m", "minimum distance of a target", kJazzy | kKilted},
      {"max_lookahead", &P::maxLookahead, "m", "maximum distance of a target", kSinceJazzy},
      {"motion_target_dist", &P::targetDistance, "m", "distance of the target", kHumble},
      {"initial_rotation", &P::initialRotation, "", "rotates in place at the start of a new path"},
      {"initial_rotation_tolerance", &P::initialRotationTolerance, "rad",
       "minimum angle for this rotation", kSinceJazzy},
      {"initial_rotation_min_angle", &P::initialRotationTolerance, "rad",
       "minimum angle for this rotation", kHumble},
      {"prefer_final_rotation", &P::prefersFinalRotation, "",
       "near the goal its heading is used only after the position is reached", kSinceJazzy},
      {"final_rotation", &P::prefersFinalRotation, "", "rotates in place to the goal's heading",
       kHumble},
      {"rotation_scaling_factor", &P::rotationScaling, "1/rad", "turn rate per remaining angle"},
      {"allow_backward", &P::allowsBackward, "", "drives backwards to targets behind the robot"},
      {"in_place_collision_resolution", &P::inPlaceResolution, "rad",
       "angle step of collision checks for rotation in place", kSinceJazzy},
      {"use_collision_detection", &P::usesCollisionDetection, "",
       "rejects commands that lead into an obstacle", kSinceKilted},
      {"footprint_scaling_linear_vel", &P::footprintScalingVelocity, "m/s",
       "speed above which the footprint is enlarged", kSinceLyrical},
      {"footprint_scaling_factor", &P::footprintScalingFactor, "",
       "enlargement at the maximum speed", kSinceLyrical},
      {"footprint_scaling_step", &P::footprintScalingStep, "m/s",
       "speed reduction when a target that led to a collision is tried again", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredGracefulKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"transform_tolerance", "TF is not used", kUntilKilted},
      {"obstacle_cost_margin", "not re-implemented: treated as its default", kSinceLyrical},
      {"final_rotation_search_step", "not re-implemented: treated as its default", kSinceLyrical},
      {"min_lookahead", "the target is interpolated at max_lookahead", kSinceLyrical},
  };
  return kKeys;
}

namespace {

double power(double x, double exponent) {  // x >= 0
  if (exponent == 2.0 || std::isinf(x)) {
    return x * x;
  }
  return x == 0.0 ? (exponent == 0.0 ? 1.0 : 0.0) : base::exp(exponent * base::log(x));
}

}  // namespace

EgoPolar egoPolar(const Pose2& target, const Pose2& robot, bool isBackward) {
  const Vec2 d = target.position - robot.position;
  const double sight = base::atan2(-d.y(), d.x()) + (isBackward ? base::kPi : 0.0);
  return {d.norm(), base::wrapToPi(target.heading + sight), base::wrapToPi(robot.heading + sight)};
}

double gracefulCurvature(const GracefulParameters& p, const EgoPolar& polar) {
  const double slow = base::atan2(-p.kPhi * polar.phi, 1.0);  // desired heading
  const double turned = p.kPhi * polar.phi;
  const double proportional = p.kDelta * (polar.delta - slow);
  const double feedback = (1.0 + p.kPhi / (1.0 + turned * turned)) * base::sin(polar.delta);
  const double steering = proportional + feedback;
  return steering == 0.0 ? 0.0 : -1.0 / polar.r * steering;  // at the target: infinite, not NaN
}

BodyTwist gracefulCommand(const GracefulParameters& p, Distro distro, const Pose2& target,
                          const Pose2& robot, bool isBackward) {
  const EgoPolar polar = egoPolar(target, robot, isBackward);
  const double sign = isBackward ? -1.0 : 1.0;
  const double curvature = sign * gracefulCurvature(p, polar);
  double v = p.maxLinear / (1.0 + p.beta * power(std::abs(curvature), p.lambda));
  v = std::min(v, p.maxLinear * polar.r / p.slowdownRadius);
  if (distro >= Distro::Lyrical) {
    v = std::min(v, std::sqrt(2.0 * polar.r * p.maxDeceleration));
  }
  v = sign * std::min(std::max(v, p.minLinear), p.maxLinear);
  const double w = std::min(std::max(curvature * v, -p.maxAngular), p.maxAngular);
  return {curvature != 0.0 ? w / curvature : v, w};
}

namespace {

constexpr char kGracefulCollision[] = "Collision detected in trajectory";

/// Planners without headings assign equal ones: then each pose is oriented towards the next.
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

/// Path length from the robot to each pose [m].
std::vector<double> pathDistances(const Path& plan) {
  std::vector<double> distances;
  double way = plan.front().position.norm();
  for (std::size_t i = 0; i < plan.size(); ++i) {
    way += i > 0 ? (plan[i].position - plan[i - 1].position).norm() : 0.0;
    distances.push_back(way);
  }
  return distances;
}

PathPruning gracefulPruning(const GracefulParameters& parameters, Distro distro) {
  PathPruning pruning;
  pruning.rule = PathPruning::Rule::Pursuit;
  pruning.searchDistance = parameters.searchDistance;
  pruning.keepsLastTwo = distro != Distro::Humble;
  return pruning;
}

Nav2KeyTable gracefulKeysOf(const Nav2ParameterBlock& /*given*/, Distro distro) {
  return keyTableOf(gracefulKeys(), gracefulDefaults(distro), ignoredGracefulKeys());
}

base::Result<std::unique_ptr<Controller>> makeGraceful(const ControllerSetup& setup) {
  base::Diagnostics problems;
  const auto parameters = applyBlock(gracefulDefaults(setup.distro), gracefulKeys(), setup.block,
                                     setup.distro, problems);
  ParameterChecks checks(problems);
  checks.within("slowdown_radius", parameters.slowdownRadius, base::kPositive, "above 0");
  checks.within("v_linear_max", parameters.maxLinear, base::kPositive, "above 0");
  checks.within("in_place_collision_resolution", parameters.inPlaceResolution, base::kPositive,
                "above 0");
  checks.within("footprint_scaling_step", parameters.footprintScalingStep, base::kPositive,
                "above 0");
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
      handler_(gracefulPruning(parameters, distro)) {}

void GracefulController::setPlan(const Path& plan) {
  handler_.setPlan(plan);
  goal_ = plan.empty() ? Pose2() : plan.back();
  isGoalReached_ = false;
  isInitialRotation_ = true;
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

ControlResult GracefulController::computeVelocityCommands(const ControlInput& input) {
  LocalPlan local = handler_.localPlan(input);
  view_ = {};
  if (local.problem != nullptr) {
    return {ControllerError::InvalidPath, local.problem};
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
  if (isGoalTurn(scene) && isRotationFree(input, goalTurn)) {
    return BodyTwist{0.0, rotationCommand(goalTurn)};
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

/// Humble: a single target at a fixed distance.
ControlResult GracefulController::followOneTarget(const Scene& scene) {
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
  isInitialRotation_ = false;  // Humble turns whenever the target is to the side
  BodyTwist command;
  if (collides(input, {}, 1.0) ||
      !simulate(input, {target, isBackward, parameters_.maxLinear}, command)) {
    return {ControllerError::NoValidControl, kGracefulCollision};
  }
  const double toTarget = base::headingOf(target.position);
  if (parameters_.prefersFinalRotation &&
      scene.plan.back().position.norm() < input.goalChecker.xyTolerance()) {
    command = {0.0, rotationCommand(scene.plan.back().heading)};
  } else if (parameters_.initialRotation &&
             std::abs(toTarget) > parameters_.initialRotationTolerance) {
    command = {0.0, rotationCommand(toTarget)};
  }
  return command;
}

/// Jazzy: the farthest reachable pose.
ControlResult GracefulController::followFarthest(const Scene& scene) {
  const std::vector<double> distances = pathDistances(scene.plan);
  BodyTwist command;
  for (std::size_t i = scene.plan.size(); i-- > 0;) {
    if (distances[i] > parameters_.maxLookahead) {
      continue;
    }
    if (scene.length >= parameters_.maxLookahead && distances[i] < parameters_.minLookahead) {
      break;
    }
    if (drive(scene, scene.plan[i], command)) {
      return command;
    }
  }
  return {ControllerError::NoValidControl, kGracefulCollision};
}

/// Main: the interpolated point at the lookahead distance, then the poses before it.
ControlResult GracefulController::followInterpolated(const Scene& scene) {
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
  const std::vector<double> distances = pathDistances(plan);
  for (std::size_t i = plan.size() - 1; i-- > 0;) {
    if (distances[i] <= most && drive(scene, plan[i], command)) {
      return command;
    }
  }
  return {ControllerError::NoValidControl, kGracefulCollision};
}

/// Tries a target; main also retries at lower speeds, and scales the footprint with the speed.
bool GracefulController::drive(const Scene& scene, Pose2 target, BodyTwist& command) {
  if (scene.length < parameters_.maxLookahead && parameters_.prefersFinalRotation) {
    target.heading = base::headingOf(target.position);  // avoids a wide turn at the end
  }
  const bool isBackward = parameters_.allowsBackward && target.position.x() < 0.0;
  if (isBackward) {
    target.heading = base::wrapToPi(target.heading + base::kPi);
  }
  view_.lookahead = {scene.input.robot.toWorld(target.position)};
  constexpr int kMaxAttempts = 100;  // the step may be 0
  Attempt attempt{target, isBackward, parameters_.maxLinear};
  int attempts = 0;
  do {
    if (simulate(scene.input, attempt, command)) {
      return true;
    }
    attempt.maxLinear -= parameters_.footprintScalingStep;
  } while (distro_ >= Distro::Lyrical && attempt.maxLinear > 0.0 && ++attempts < kMaxAttempts &&
           attempt.maxLinear >= parameters_.footprintScalingVelocity);
  return false;
}

/// Whether the initial rotation is complete or disabled.
bool GracefulController::isInitialRotationDone(const Pose2& target) {
  if (std::abs(base::headingOf(target.position)) < parameters_.initialRotationTolerance) {
    isInitialRotation_ = false;
  }
  return !isInitialRotation_ || !parameters_.initialRotation;
}

/// Simulates the control law up to the target; `command` is the first command. False: collision.
bool GracefulController::simulate(const ControlInput& input, const Attempt& attempt,
                                  BodyTwist& command) {
  GracefulParameters law = parameters_;
  law.maxLinear = attempt.maxLinear;
  const double resolution = input.costmap.resolution();
  const double dt = resolution / law.maxLinear;
  const double toTarget = base::headingOf(attempt.target.position);
  bool isTurning = !isInitialRotationDone(attempt.target);
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
      twist = way.empty() ? BodyTwist{0.0, rotationCommand(left)} : command;
      isTurning = std::abs(left) >= law.initialRotationTolerance;
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

bool GracefulController::isRotationFree(const ControlInput& input, double angle) const {
  constexpr double kMaxSteps = 1000.0;
  const double wanted = std::abs(angle) / parameters_.inPlaceResolution;
  const int steps = static_cast<int>(std::min(std::max(wanted, 1.0), kMaxSteps));
  for (int i = 1; i <= steps; ++i) {
    if (collides(input, {Vec2::Zero(), static_cast<double>(i) / steps * angle}, 1.0)) {
      return false;
    }
  }
  return true;
}

bool GracefulController::collides(const ControlInput& input, const Pose2& local,
                                  double scale) const {
  if (distro_ >= Distro::Kilted && !parameters_.usesCollisionDetection) {
    return false;
  }
  const Pose2 pose{input.robot.toWorld(local.position), input.robot.heading + local.heading};
  const auto cell = input.costmap.worldToCell(pose.position);
  if (!cell) {
    return false;
  }
  const RobotFootprint& shape = input.shape;
  if (shape.isRadius) {
    return isCentreCollision(input.costmap.at(*cell), shape.tracksUnknown);
  }
  if (scale == 1.0) {
    return isPoseInCollision(input, pose);
  }
  Polygon corners = shape.vertices;
  for (Vec2& corner : corners) {
    corner *= scale;
  }
  return isEdgeCollision(footprintCost(input.costmap, corners, pose), shape.tracksUnknown);
}

double GracefulController::rotationCommand(double angle) const {
  const double w = parameters_.rotationScaling * angle * parameters_.maxAngular;
  const double least = distro_ == Distro::Humble ? 0.0 : parameters_.minAngularInPlace;
  return std::copysign(std::max(std::abs(w), least), w);
}

ControllerType gracefulController() {
  return {"nav2_graceful_controller::GracefulController", gracefulKeysOf, makeGraceful};
}

}  // namespace sim2d::nav2
