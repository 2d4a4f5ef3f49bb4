#include "sim2d/nav/nav2/control/RegulatedPurePursuit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/ControllerUtils.h"
#include "sim2d/nav/nav2/control/RegulationFunctions.h"

namespace sim2d::nav2 {
namespace {

constexpr char kPursuitCollision[] = "RegulatedPurePursuitController detected collision ahead!";
constexpr char kPursuitOffMap[] =
    "RegulatedPurePursuitController: Dimensions of the costmap are too small to encapsulate the "
    "robot footprint at current speeds!";

PathPruning pursuitPruning(const PursuitParameters& parameters, Distro distro) {
  PathPruning pruning;
  pruning.rule = PathPruning::Rule::Pursuit;
  pruning.searchDistance = parameters.searchDistance;
  pruning.keepsLastTwo = distro != Distro::Humble;
  pruning.rejectsUnitPath = parameters.interpolatesCurvatureAfterGoal;
  return pruning;
}

Nav2KeyTable pursuitKeysOf(const Nav2ParameterBlock& /*given*/, Distro /*distro*/) {
  return keyTableOf(pursuitKeys(), PursuitParameters(), ignoredPursuitKeys());
}

base::Result<std::unique_ptr<Controller>> makePursuit(const ControllerSetup& setup) {
  base::Diagnostics problems;
  auto parameters =
      applyBlock(PursuitParameters(), pursuitKeys(), setup.block, setup.distro, problems);
  if (!(parameters.inflationCostScaling > 0.0)) {
    problems.push_back(base::warning(
        "nav2.scaling-off", {"inflation_cost_scaling_factor", parameters.inflationCostScaling}));
    parameters.regulatesByCost = false;
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  if (parameters.rotatesToHeading && parameters.allowsReversing) {
    problems.push_back(
        base::warning("nav2.not-both", {"allow_reversing", "use_rotate_to_heading"}));
    parameters.allowsReversing = false;
  }
  if (parameters.interpolatesCurvatureAfterGoal && !parameters.usesFixedCurvatureLookahead) {
    problems.push_back(base::warning(
        "nav2.not-without", {"interpolate_curvature_after_goal", "use_fixed_curvature_lookahead"}));
    parameters.interpolatesCurvatureAfterGoal = false;
  }
  return {std::make_unique<RegulatedPurePursuit>(parameters, setup.distro, setup.frequency),
          std::move(problems)};
}

}  // namespace

RegulatedPurePursuit::RegulatedPurePursuit(const PursuitParameters& parameters, Distro distro,
                                           double frequency)
    : parameters_(parameters),
      fullLinearVelocity_(parameters.maxLinearVelocity),
      distro_(distro),
      period_(1.0 / frequency),
      handler_(pursuitPruning(parameters, distro)) {}

void RegulatedPurePursuit::setPlan(const Path& plan) {
  isGoalLatched_ = false;
  handler_.setPlan(plan);
  goal_ = plan.empty() ? Pose2() : plan.back();
}

void RegulatedPurePursuit::reset() {
  isCancelling_ = false;
  isCancelled_ = false;
  isGoalLatched_ = false;
}

bool RegulatedPurePursuit::cancel() {
  if (!parameters_.usesCancelDeceleration) {
    return true;
  }
  isCancelling_ = true;
  return isCancelled_;
}

void RegulatedPurePursuit::setSpeedLimit(double limit, bool isPercentage) {
  if (limit == 0.0) {
    parameters_.maxLinearVelocity = fullLinearVelocity_;
  } else {
    parameters_.maxLinearVelocity = isPercentage ? fullLinearVelocity_ * limit / 100.0 : limit;
  }
}

ControlResult RegulatedPurePursuit::computeVelocityCommands(const ControlInput& input) {
  LocalPlan local = handler_.localPlan(input);
  view_.localPlan = local.poses;
  view_.predicted.clear();
  view_.lookahead.clear();
  if (local.problem != nullptr) {
    return {ControllerError::InvalidPath, local.problem};
  }
  const RobotFrame frame(input.robot);
  for (Pose2& pose : local.poses) {
    pose = frame.toLocal(pose);
  }
  const Pursuit pursuit = findCarrots(local.poses, input.speed.linear);
  view_.lookahead = {input.robot.toWorld(pursuit.carrot)};
  if (pursuit.headingCarrot != pursuit.carrot) {
    view_.lookahead.push_back(input.robot.toWorld(pursuit.headingCarrot));
  }
  return command(input, local.poses, pursuit);
}

RegulatedPurePursuit::Pursuit RegulatedPurePursuit::findCarrots(const Path& plan,
                                                                double speed) const {
  const PursuitParameters& p = parameters_;
  double lookahead = lookaheadDistance(p, speed);
  double curvatureLookahead = p.curvatureLookahead;
  if (p.allowsReversing && distro_ < Distro::Lyrical) {  // main's path handler ends paths at cusps
    const double cusp = distanceToCusp(plan);
    lookahead = std::min(lookahead, cusp);
    curvatureLookahead = std::min(curvatureLookahead, cusp);
  }
  Pursuit pursuit;
  pursuit.carrot = carrotAt(plan, lookahead, p.usesInterpolation, false);
  pursuit.headingCarrot = pursuit.carrot;
  if (p.usesFixedCurvatureLookahead) {
    pursuit.headingCarrot =
        carrotAt(plan, curvatureLookahead, p.usesInterpolation, p.interpolatesCurvatureAfterGoal);
  }
  pursuit.sign = p.allowsReversing && pursuit.carrot.x() < 0.0 ? -1.0 : 1.0;
  return pursuit;
}

ControlResult RegulatedPurePursuit::command(const ControlInput& input, const Path& plan,
                                            const Pursuit& pursuit) {
  const RotationLimits turn{parameters_.rotateVelocity, parameters_.maxAngularAcceleration};
  double toPath = base::headingOf(pursuit.headingCarrot);
  if (pursuit.sign < 0.0) {
    toPath = base::wrapToPi(toPath + base::kPi);
  }
  BodyTwist twist;
  if (isGoalTurn(input, plan, pursuit.carrot)) {
    twist.angular = rotationVelocity(turn, plan.back().heading, input.speed.angular, period_);
  } else if (parameters_.rotatesToHeading && std::abs(toPath) > parameters_.rotateMinAngle) {
    twist.angular = rotationVelocity(turn, toPath, input.speed.angular, period_);
  } else {
    const auto cell = input.costmap.worldToCell(input.robot.position);
    if (!cell) {
      return {ControllerError::Unknown, kPursuitOffMap};
    }
    twist = follow(input, plan, pursuit, input.costmap.at(*cell));
  }
  if (parameters_.usesCollisionDetection &&
      collides(input, twist, pursuit.carrot.norm(), pathLength(plan))) {
    return {ControllerError::NoValidControl, kPursuitCollision};
  }
  return twist;
}

bool RegulatedPurePursuit::isGoalTurn(const ControlInput& input, const Path& plan,
                                      const Vec2& carrot) {
  if (!parameters_.rotatesToHeading) {
    return false;
  }
  if (distro_ >= Distro::Lyrical) {
    return input.goalChecker.isXyReached(
        {input.robot, input.fromPlan(goal_), input.speed, pathLength(plan), input.localPlan});
  }
  const bool isNear = carrot.norm() < input.goalChecker.xyTolerance();
  if (includesDistro(kJazzy | kKilted, distro_) && parameters_.isStateful) {
    isGoalLatched_ = isGoalLatched_ || isNear;
    return isGoalLatched_;
  }
  return isNear;
}

BodyTwist RegulatedPurePursuit::follow(const ControlInput& input, const Path& plan,
                                       const Pursuit& pursuit, std::uint8_t cost) {
  const double curvature = curvatureTo(pursuit.headingCarrot);
  SpeedRegulation regulation;
  regulation.curvature = curvature;
  regulation.cost = cost;
  regulation.inscribedRadius = input.shape.inscribedRadius;
  regulation.pathLength = pathLength(plan);
  regulation.goalDistance = plan.back().position.norm();
  regulation.sign = pursuit.sign;
  double linear = regulatedSpeed(parameters_, distro_, parameters_.maxLinearVelocity, regulation);
  if (isCancelling_) {
    brakeForCancel(input.speed.linear, pursuit.sign, linear);
  }
  if (distro_ >= Distro::Lyrical && parameters_.usesDynamicWindow) {
    const VelocityWindow window =
        regulatedWindow(velocityWindow(parameters_, input.speed, period_), linear);
    return bestInWindow(window, curvature, pursuit.sign);
  }
  return {linear, linear * curvature};
}

void RegulatedPurePursuit::brakeForCancel(double speed, double sign, double& linear) {
  linear = speed - sign * period_ * parameters_.cancelDeceleration;
  if (sign * linear <= 0.0) {
    linear = 0.0;
    isCancelled_ = true;
  }
}

bool RegulatedPurePursuit::collides(const ControlInput& input, const BodyTwist& twist, double range,
                                    double length) {
  const PursuitParameters& p = parameters_;
  if (isPoseInCollision(input, input.robot)) {
    return true;
  }
  double allowed = p.maxTimeToCollision;
  if (distro_ >= Distro::Kilted && p.minDistanceToObstacle > 0.0) {
    const double d = p.minDistanceToObstacle;
    allowed = std::max(allowed, d / std::max(std::abs(twist.linear), p.minApproachVelocity));
    if (p.usesVelocityScaledLookahead) {
      const double wanted = p.checksBeyondGoal ? d : std::min(d, length);
      range = std::min(std::max(range, wanted), p.maxLookahead);
    }
  }
  const double resolution = input.costmap.resolution();
  const bool isTurn = std::abs(twist.linear) < 0.01 && std::abs(twist.angular) > 0.01;
  const double step = isTurn ? 2.0 * base::sin(resolution / 2.0 / input.shape.circumscribedRadius) /
                                   std::abs(twist.angular)
                             : resolution / std::abs(twist.linear);
  // The sine for a robot smaller than a cell may be negative; the loop would not end.
  constexpr int kMaxSteps = 10000;
  Pose2 pose = input.robot;
  for (int i = 1; step > 0.0 && i * step < allowed && i <= kMaxSteps; ++i) {
    pose.position += step * twist.linear * pose.direction();
    pose.heading += step * twist.angular;
    if ((pose.position - input.robot.position).norm() > range) {
      return false;
    }
    view_.predicted.push_back(pose);
    if (isPoseInCollision(input, pose)) {
      return true;
    }
  }
  return false;
}

ControllerType regulatedPurePursuit() {
  return {"nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController", pursuitKeysOf,
          makePursuit};
}

namespace {

struct WindowAxis {
  double least, most;   // [m/s] or [rad/s]
  double acceleration;  // > 0
  double deceleration;  // < 0
};

/// Minimum and maximum reachable velocity.
std::pair<double, double> reachable(const WindowAxis& axis, double now, double dt) {
  constexpr double kStanding = 1e-3;
  double most = now + axis.acceleration * dt;
  double least = now - axis.acceleration * dt;
  if (now > kStanding) {
    least = now + axis.deceleration * dt;
  } else if (now < -kStanding) {
    most = now - axis.deceleration * dt;
  }
  return {std::max(least, axis.least), std::min(most, axis.most)};
}

bool contains(const VelocityWindow& window, const BodyTwist& twist) {
  return twist.linear >= window.minLinear && twist.linear <= window.maxLinear &&
         twist.angular >= window.minAngular && twist.angular <= window.maxAngular;
}

BodyTwist straightInWindow(const VelocityWindow& window, double sign) {
  const double linear = sign >= 0.0 ? window.maxLinear : window.minLinear;
  if (window.minAngular <= 0.0 && 0.0 <= window.maxAngular) {
    return {linear, 0.0};
  }
  const bool isMinNearer = std::abs(window.minAngular) <= std::abs(window.maxAngular);
  return {linear, isMinNearer ? window.minAngular : window.maxAngular};
}

BodyTwist nearestCorner(const VelocityWindow& window, double curvature, double sign) {
  constexpr double kSame = 1e-3;
  const BodyTwist corners[] = {{window.minLinear, window.minAngular},
                               {window.minLinear, window.maxAngular},
                               {window.maxLinear, window.minAngular},
                               {window.maxLinear, window.maxAngular}};
  BodyTwist best = corners[0];
  double least = std::numeric_limits<double>::infinity();
  const double length = std::sqrt(1.0 + curvature * curvature);
  for (const BodyTwist& corner : corners) {
    const double distance = std::abs(curvature * corner.linear - corner.angular) / length;
    const bool isSame = std::abs(distance - least) <= kSame;
    if (distance < least || (isSame && corner.linear * sign > best.linear * sign)) {
      best = corner;
      least = distance;
    }
  }
  return best;
}

}  // namespace

VelocityWindow velocityWindow(const PursuitParameters& p, const BodyTwist& now, double dt) {
  VelocityWindow window;
  std::tie(window.minLinear, window.maxLinear) = reachable(
      {p.minLinearVelocity, p.maxLinearVelocity, p.maxLinearAcceleration, p.maxLinearDeceleration},
      now.linear, dt);
  std::tie(window.minAngular, window.maxAngular) =
      reachable({p.minAngularVelocity, p.maxAngularVelocity, p.maxAngularAcceleration,
                 p.maxAngularDeceleration},
                now.angular, dt);
  return window;
}

VelocityWindow regulatedWindow(VelocityWindow window, double speed) {
  window.maxLinear = std::min(window.maxLinear, std::max(speed, 0.0));
  window.minLinear = std::max(window.minLinear, std::min(speed, 0.0));
  if (window.maxLinear < window.minLinear) {
    if (window.minLinear > 0.0) {
      window.maxLinear = window.minLinear;
    } else {
      window.minLinear = window.maxLinear;
    }
  }
  return window;
}

BodyTwist bestInWindow(const VelocityWindow& window, double curvature, double sign) {
  constexpr double kStraight = 1e-3;  // [1/m]
  if (std::abs(curvature) < kStraight) {
    return straightInWindow(window, sign);
  }
  const BodyTwist crossings[] = {{window.minLinear, curvature * window.minLinear},
                                 {window.maxLinear, curvature * window.maxLinear},
                                 {window.minAngular / curvature, window.minAngular},
                                 {window.maxAngular / curvature, window.maxAngular}};
  const BodyTwist* best = nullptr;
  for (const BodyTwist& crossing : crossings) {
    if (contains(window, crossing) &&
        (best == nullptr || crossing.linear * sign > best->linear * sign)) {
      best = &crossing;
    }
  }
  return best != nullptr ? *best : nearestCorner(window, curvature, sign);
}

}  // namespace sim2d::nav2
