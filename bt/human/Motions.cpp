#include "bt/human/Motions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bt {

using base::Pose2;
using base::Vec2;
using sim2d::Intent;
using sim2d::Motion;
using sim2d::RobotTreatment;
using sim2d::WorldView;

double bearingOf(const Vec2& point, const Pose2& observer) {
  const Vec2 offset = point - observer.position;
  if (offset.isZero(0.0)) {
    return 0.0;
  }
  return base::angleDiff(base::headingOf(offset), observer.heading);
}

double robotDistance(const WorldView& view, int human) {
  const int robot = view.nearestRobot(human);
  if (robot < 0) {
    return std::numeric_limits<double>::infinity();
  }
  return (view.robotPose(robot).position - view.pose(human).position).norm();
}

namespace {

bool isVisible(const WorldView& view, int observer, const Vec2& place, double distance,
               double halfView) {
  const Pose2 pose = view.pose(observer);
  return (place - pose.position).norm() <= distance &&
         std::fabs(bearingOf(place, pose)) <= halfView && view.isVisible(pose.position, place);
}

}  // namespace

bool isRobotVisible(const WorldView& view, AgentIndex human, double distance) {
  const int robot = view.nearestRobot(human);
  return robot >= 0 &&
         isVisible(view, human, view.robotPose(robot).position, distance, kDefaultHalfView);
}

bool isAgentVisible(const WorldView& view, AgentIndex observer, AgentIndex target, double distance,
                    double halfView) {
  return isVisible(view, observer, view.pose(target).position, distance, halfView);
}

bool isRobotFacing(const WorldView& view, AgentIndex human) {
  const int robot = view.nearestRobot(human);
  return robot >= 0 &&
         std::fabs(bearingOf(view.pose(human).position, view.robotPose(robot))) < kFacingAngle;
}

bool isAudible(const WorldView& view, int listener, int speaker, double distance) {
  return agentDistance(view, listener, speaker) <= distance &&
         view.isVisible(view.pose(speaker).position, view.pose(listener).position);
}

double agentDistance(const WorldView& view, int from, int to) {
  return (view.pose(to).position - view.pose(from).position).norm();
}

int nearestAgent(const WorldView& view, int human) {
  int nearest = -1;
  double shortest = std::numeric_limits<double>::infinity();
  for (int other = 0; other < view.humanCount(); ++other) {
    if (other == human || !view.isPresent(other)) {
      continue;
    }
    const double distance = agentDistance(view, human, other);
    const bool isTie = distance == shortest && nearest >= 0 &&
                       view.constants(other).id < view.constants(nearest).id;
    if (distance < shortest || isTie) {
      nearest = other;
      shortest = distance;
    }
  }
  return nearest;
}

namespace {

constexpr double kTurnPerTick = 0.2 * base::kPi;    // HuNavSim's look nodes
constexpr double kNudgePerTick = 0.01 * base::kPi;  // HuNavSim's approach nodes within `closest`
constexpr double kReachedBlock = 0.8;               // [m] around the point in front of the robot
constexpr double kReachedSpot = 0.2;                // [m] around the point in front of a person
constexpr double kFollowSpeed = 1.5;                // HuNavSim's default [m/s]
constexpr double kMovingRobot = 0.1;                // [m/s]
constexpr double kForceDecay = 0.2;                 // sigma of the obstacle force [m]
constexpr double kSmallestGap = 0.05;               // [m]

Intent standing() {
  Intent intent;
  intent.active = true;
  return intent;
}

Intent turning(double heading) {
  Intent intent;
  intent.motion = Motion::Turn;
  intent.heading = heading;
  intent.turnRate = kTurnRate;
  intent.active = true;
  return intent;
}

/// A turn that completes within this step, regardless of the angle.
Intent snapping(const HumanContext& context, double heading) {
  Intent intent = turning(base::wrapToPi(heading));
  intent.turnRate = base::kPi / context.view().dt();
  return intent;
}

Intent facing(const HumanContext& context, int human, const Vec2& point) {
  const Pose2 pose = context.view().pose(human);
  return turning(base::wrapToPi(pose.heading + bearingOf(point, pose)));
}

Intent walking(const Vec2& position, double radius, double speed, RobotTreatment robot) {
  Intent intent;
  intent.motion = Motion::Walk;
  intent.target.position = position;
  intent.target.radius = radius;
  intent.speed = speed;
  intent.robot = robot;
  intent.active = true;
  return intent;
}

double distanceTo(const HumanContext& context, int human, const Vec2& point) {
  return (point - context.view().pose(human).position).norm();
}

}  // namespace

std::optional<Target> nearestRobotOf(const WorldView& view, int human) {
  const int robot = view.nearestRobot(human);
  if (robot < 0) {
    return std::nullopt;
  }
  return Target{view.robotPose(robot), view.robotRadius(robot), true};
}

Target agentTarget(const WorldView& view, int human) {
  return {view.pose(human), view.constants(human).radius, false};
}

double ownSpeed(HumanContext& context, int human) {
  return context.control(human).frozen ? 0.0 : context.view().constants(human).desiredSpeed;
}

RobotTreatment robotTreatment(const HumanContext& context, int human, bool isReacting) {
  const bool isImpassive =
      context.view().constants(human).behavior == sim2d::BehaviorType::Impassive &&
      !context.hasQuirk(29);
  return isImpassive || isReacting ? RobotTreatment::Obstacle : RobotTreatment::Pedestrian;
}

Intent walkTo(HumanContext& context, int human, const sim2d::GoalItem& place) {
  Intent intent;
  intent.robot = robotTreatment(context, human, false);
  intent.speed = ownSpeed(context, human);
  if (intent.speed > 0.0) {
    intent.motion = Motion::Walk;
    intent.target = place;
  }
  return intent;
}

Intent regularWalk(HumanContext& context, int human) {
  const std::vector<sim2d::GoalItem>& goals = context.control(human).goals;
  if (goals.empty()) {
    Intent intent;
    intent.motion = Motion::Brake;
    intent.robot = robotTreatment(context, human, false);
    return intent;
  }
  Intent intent = walkTo(context, human, goals.front());
  intent.targetIsGoal = true;
  return intent;
}

MotionPlan turnTo(const HumanContext& context, int human, const Vec2& point, double tolerance) {
  const double error = std::fabs(bearingOf(point, context.view().pose(human)));
  const double left = error - kTurnRate * context.view().dt();
  return {facing(context, human, point), std::max(left, 0.0) <= tolerance};
}

MotionPlan lookAt(const HumanContext& context, int human, const Vec2& point, double tolerance) {
  if (!context.hasQuirk(6)) {
    return turnTo(context, human, point, tolerance);
  }
  const Pose2 pose = context.view().pose(human);
  const double bearing = bearingOf(point, pose);
  const double turn = bearing >= 0.0 ? std::min(bearing, kTurnPerTick) : -kTurnPerTick;
  const double left = std::fabs(base::wrapToPi(bearing - turn));
  return {snapping(context, pose.heading + turn), left <= tolerance};
}

Intent approach(const HumanContext& context, int human, const Target& target, const Approach& how) {
  const double distance = distanceTo(context, human, target.pose.position);
  if (distance > how.closest) {
    return walking(target.pose.position, target.radius,
                   how.maxSpeed * distance / (distance + how.closest),
                   robotTreatment(context, human, target.isRobot));
  }
  if (!context.hasQuirk(6)) {
    return facing(context, human, target.pose.position);
  }
  const Pose2 pose = context.view().pose(human);
  const double bearing = bearingOf(target.pose.position, pose);
  return snapping(context, pose.heading + std::clamp(bearing, -kNudgePerTick, kNudgePerTick));
}

Intent follow(HumanContext& context, int human, const Target& target, const Approach& how) {
  const double own = ownSpeed(context, human);
  const double distance = distanceTo(context, human, target.pose.position);
  const double ratio = how.closest > 0.0 ? std::min(distance / how.closest, 1.0) : 1.0;
  const bool hasQuirk = context.hasQuirk(18);
  const double limit = how.maxSpeed >= 0.0 ? how.maxSpeed : hasQuirk ? kFollowSpeed : own;
  const double near = limit * ratio * ratio;
  const double speed = hasQuirk && ratio >= 1.0 ? own : std::min(own, near);
  return walking(target.pose.position, target.radius, speed, robotTreatment(context, human, false));
}

Intent blockRobot(const HumanContext& context, int human, const Target& robot, double robotSpeed,
                  double front) {
  const double ahead = front > 0.5 ? front : 1.5;
  const Vec2 ideal = robot.pose.ahead(ahead);
  const bool isInPlace = distanceTo(context, human, ideal) <= kReachedBlock &&
                         distanceTo(context, human, robot.pose.position) <= front + kReachedBlock;
  if (!isInPlace) {
    return walking(ideal, 0.2, 2.5, RobotTreatment::Obstacle);
  }
  return robotSpeed > kMovingRobot ? standing() : facing(context, human, robot.pose.position);
}

Intent blockAgent(const HumanContext& context, int human, const Target& person, double front) {
  const Vec2 ahead = person.pose.direction();
  const Vec2 direction = context.hasQuirk(7) ? Vec2(ahead.y(), ahead.x()) : ahead;
  const Vec2 ideal = person.pose.position + front * direction;
  if (distanceTo(context, human, ideal) <= kReachedSpot) {
    return facing(context, human, person.pose.position);
  }
  return walking(ideal, 0.05, 2.0, robotTreatment(context, human, false));
}

Intent avoid(const HumanContext& context, int human, const Target& target, const Escape& how) {
  const Pose2 pose = context.view().pose(human);
  const Vec2 away = pose.position - target.pose.position;
  const double distance = away.norm();
  if (distance >= how.safe) {
    return facing(context, human, target.pose.position);
  }
  const Vec2 direction = distance > 0.1 ? Vec2(away / distance) : pose.direction();
  const Vec2 refuge = target.pose.position + (how.safe + how.beyond) * direction;
  return walking(refuge, kEscapeRadius, how.speed, robotTreatment(context, human, target.isRobot));
}

Intent walkWithRobotRepulsion(HumanContext& context, int human, const Target& robot, double speed,
                              double factor) {
  const Pose2 pose = context.view().pose(human);
  const Vec2 away = pose.position - robot.pose.position;
  const double distance = away.norm();
  const Vec2 direction = distance > 0.0 ? Vec2(away / distance) : pose.direction();
  const double gap = std::max(distance - context.view().constants(human).radius, kSmallestGap);
  const std::vector<sim2d::GoalItem>& goals = context.control(human).goals;
  Intent intent = walking(pose.position + direction, 0.3, speed, RobotTreatment::Obstacle);
  if (!goals.empty()) {
    intent.target = goals.front();
    intent.targetIsGoal = true;
  }
  intent.extraForce = factor * kForceDecay / gap * direction;
  return intent;
}

}  // namespace bt
