#include "sim2d/nav/DriveGear.h"

#include <algorithm>
#include <cmath>

#include "sim2d/nav/VelocityPlanes.h"

namespace sim2d {
namespace {

constexpr double kGearStanding = 0.02;  // [m/s]
constexpr double kGearBlocked = 1.0;    // [s] of standing before the gear is changed
constexpr double kGearFor = 2.0;        // [s] at least, unless blocked
constexpr double kLongestBack = 6.0;    // [s]
constexpr double kClearOfCircle = 1.2;  // of the turning radius, to go ahead again
constexpr double kNearEnough = 0.8;     // of the goal's radius: an arc may miss a point by that
constexpr double kRadiiAhead = 1.5;

}  // namespace

BodyTwist DriveAim::commandOf(const BodyTwist& twist) const {
  return isBacking ? BodyTwist{-twist.linear, twist.angular, -twist.lateral} : twist;
}

DriveGear::DriveGear(const RobotBody& body, double turnTime)
    : model_(trackingModelOf(body, turnTime)), maxReverse_(body.limits.maxReverse) {}

double DriveGear::leastLookahead() const {
  return model_.kinematics == Kinematics::Ackermann ? kRadiiAhead * model_.turningRadius : 0.0;
}

/// Inside of the circle to its left or right; `target` in robot frame.
bool DriveGear::isOutOfReach(const Vec2& target, double radius) const {
  return Vec2(target.x(), std::fabs(target.y()) - model_.turningRadius).norm() < radius;
}

void DriveGear::update(const Observation& observation, const Vec2& target, bool wantsToMove) {
  const double time = observation.time;
  if (movedAt_ < 0.0 || !wantsToMove || std::fabs(observation.motion.linear) > kGearStanding) {
    movedAt_ = time;
  }
  bool isChanging = time - movedAt_ > kGearBlocked;
  const double lasted = time - since_;
  if (isBacking_) {
    isChanging =
        isChanging || lasted > kLongestBack ||
        (lasted > kGearFor && !isOutOfReach(target, kClearOfCircle * model_.turningRadius));
  } else if (lasted > kGearFor) {
    const double missed = model_.turningRadius - kNearEnough * observation.goalRadius;
    isChanging = isChanging || (wantsToMove && isOutOfReach(target, missed));
  }
  if (isChanging) {
    isBacking_ = !isBacking_;
    since_ = time;
    movedAt_ = time;
  }
}

DriveAim DriveGear::choose(const Observation& observation, const Vec2& target, const Vec2& wanted,
                           double epsilon) {
  const Pose2& pose = observation.pose;
  DriveAim aim{model_, pose.heading, wanted, false};
  if (model_.kinematics != Kinematics::Ackermann) {
    return aim;
  }
  const double speed = wanted.norm();
  if (maxReverse_ > 0.0) {
    update(observation, pose.toLocal(target), speed > 0.0);
  }
  const double bearing = base::headingOf(turnedBy(wanted, -pose.heading));
  const double most = steeringAngle(model_.turningRadius, epsilon);
  double aside = std::clamp(bearing, -most, most);
  aim.isBacking = isBacking_;
  if (isBacking_) {
    aim.model.maxVel = std::min(model_.maxVel, maxReverse_);
    aim.heading = base::wrapToPi(pose.heading + base::kPi);
    aside = bearing > 0.0 ? most : -most;
  }
  aim.wanted =
      std::min(speed, aim.model.maxVel) * base::directionOf(base::wrapToPi(aim.heading + aside));
  return aim;
}

}  // namespace sim2d
