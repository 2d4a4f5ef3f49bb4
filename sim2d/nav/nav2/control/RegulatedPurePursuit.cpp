#include "sim2d/nav/nav2/control/RegulatedPurePursuit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/DynamicWindowPursuit.h"
#include "sim2d/nav/nav2/control/HeadingTurn.h"
#include "sim2d/nav/nav2/control/PoseCollision.h"
#include "sim2d/nav/nav2/control/PursuitRules.h"

namespace sim2d::nav2 {
namespace {

constexpr char kPursuitCollision[] = "RegulatedPurePursuitController detected collision ahead!";
constexpr char kPursuitOffMap[] =
    "RegulatedPurePursuitController: Dimensions of the costmap are too small to encapsulate the "
    "robot footprint at current speeds!";

PathHandling pursuitHandling(const PursuitParameters& parameters, Distro distro) {
  PathHandling handling;
  handling.rule = PathHandling::Rule::Pursuit;
  handling.searchDistance = parameters.searchDistance;
  handling.keepsTwo = distro != Distro::Humble;
  handling.rejectsUnitPath = parameters.interpolatesAfterGoal;
  return handling;
}

base::Result<std::unique_ptr<Controller>> makePursuit(const ControllerSetup& setup) {
  base::Diagnostics problems;
  auto parameters = filled(PursuitParameters(), pursuitKeys(), setup.block, setup.distro, problems);
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
  if (parameters.interpolatesAfterGoal && !parameters.fixesCurvatureLookahead) {
    problems.push_back(base::warning(
        "nav2.not-without", {"interpolate_curvature_after_goal", "use_fixed_curvature_lookahead"}));
    parameters.interpolatesAfterGoal = false;
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
      handler_(pursuitHandling(parameters, distro)) {}

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
  if (!parameters_.decelerantCancel) {
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

Control RegulatedPurePursuit::computeVelocityCommands(const ControlInput& input) {
  LocalPlan local = handler_.localPlan(input);
  view_.localPlan = local.poses;
  view_.predicted.clear();
  view_.lookahead.clear();
  if (local.problem != nullptr) {
    return {ControlCode::InvalidPath, local.problem};
  }
  const RobotFrame frame(input.robot);
  for (Pose2& pose : local.poses) {
    pose = frame.toLocal(pose);
  }
  const Pursuit pursuit = pursue(local.poses, input.speed.linear);
  view_.lookahead = {input.robot.toWorld(pursuit.carrot)};
  if (pursuit.headingCarrot != pursuit.carrot) {
    view_.lookahead.push_back(input.robot.toWorld(pursuit.headingCarrot));
  }
  return command(input, local.poses, pursuit);
}

RegulatedPurePursuit::Pursuit RegulatedPurePursuit::pursue(const Path& plan, double speed) const {
  const PursuitParameters& p = parameters_;
  double lookahead = lookaheadDistance(p, speed);
  double curvatureLookahead = p.curvatureLookahead;
  if (p.allowsReversing && distro_ < Distro::Lyrical) {  // main's path handler ends at cusps
    const double cusp = distanceToCusp(plan);
    lookahead = std::min(lookahead, cusp);
    curvatureLookahead = std::min(curvatureLookahead, cusp);
  }
  Pursuit pursuit;
  pursuit.carrot = carrotAt(plan, lookahead, p.interpolates, false);
  pursuit.headingCarrot = pursuit.carrot;
  if (p.fixesCurvatureLookahead) {
    pursuit.headingCarrot =
        carrotAt(plan, curvatureLookahead, p.interpolates, p.interpolatesAfterGoal);
  }
  pursuit.sign = p.allowsReversing && pursuit.carrot.x() < 0.0 ? -1.0 : 1.0;
  return pursuit;
}

Control RegulatedPurePursuit::command(const ControlInput& input, const Path& plan,
                                      const Pursuit& pursuit) {
  const HeadingTurn turn{parameters_.rotateVelocity, parameters_.maxAngularAcceleration};
  double toPath = base::headingOf(pursuit.headingCarrot);
  if (pursuit.sign < 0.0) {
    toPath = base::wrapToPi(toPath + base::kPi);
  }
  BodyTwist twist;
  if (isGoalTurn(input, plan, pursuit.carrot)) {
    twist.angular = turnVelocity(turn, plan.back().heading, input.speed.angular, period_);
  } else if (parameters_.rotatesToHeading && std::abs(toPath) > parameters_.rotateMinAngle) {
    twist.angular = turnVelocity(turn, toPath, input.speed.angular, period_);
  } else {
    const auto cell = input.costmap.worldToCell(input.robot.position);
    if (!cell) {
      return {ControlCode::Unknown, kPursuitOffMap};
    }
    twist = follow(input, plan, pursuit, input.costmap.at(*cell));
  }
  if (parameters_.detectsCollisions &&
      collides(input, twist, pursuit.carrot.norm(), pathLength(plan))) {
    return {ControlCode::NoValidControl, kPursuitCollision};
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
  if (isIn(kJazzy | kKilted, distro_) && parameters_.isStateful) {
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
  if (isPoseInCollision(input, input.robot, OffMap::IsFree)) {
    return true;
  }
  double allowed = p.maxTimeToCollision;
  if (distro_ >= Distro::Kilted && p.minDistanceToObstacle > 0.0) {
    const double d = p.minDistanceToObstacle;
    allowed = std::max(allowed, d / std::max(std::abs(twist.linear), p.minApproachVelocity));
    if (p.scalesLookahead) {
      const double wanted = p.checksBeyondGoal ? d : std::min(d, length);
      range = std::min(std::max(range, wanted), p.maxLookahead);
    }
  }
  const double resolution = input.costmap.resolution();
  const bool isTurn = std::abs(twist.linear) < 0.01 && std::abs(twist.angular) > 0.01;
  const double step = isTurn ? 2.0 * base::sin(resolution / 2.0 / input.shape.circumscribedRadius) /
                                   std::abs(twist.angular)
                             : resolution / std::abs(twist.linear);
  // The sine of a robot smaller than a cell may be negative: such steps would never end.
  constexpr int kMostSteps = 10000;
  Pose2 pose = input.robot;
  for (int i = 1; step > 0.0 && i * step < allowed && i <= kMostSteps; ++i) {
    pose.position += step * twist.linear * pose.direction();
    pose.heading += step * twist.angular;
    if ((pose.position - input.robot.position).norm() > range) {
      return false;
    }
    view_.predicted.push_back(pose);
    if (isPoseInCollision(input, pose, OffMap::IsFree)) {
      return true;
    }
  }
  return false;
}

void addRegulatedPurePursuit(ControllerRegistry& registry) {
  ControllerType type;
  type.plugin = "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController";
  type.help = "Follows a carrot on the path, slowly in curves and near obstacles.";
  type.keys = [](const Nav2Block&, Distro) {
    Nav2Keys keys;
    addRows(keys, pursuitKeys(), PursuitParameters());
    addIdle(keys, pursuitIdleKeys());
    return keys;
  };
  type.make = makePursuit;
  registry.add(std::move(type));
}

}  // namespace sim2d::nav2
