#include "sim2d/nav/Motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim2d/base/Math.h"

namespace sim2d {
namespace {

/// sin(x) / x: the length of a chord over the length of its arc, x half the angle of the arc.
double chordOverArc(double x) {
  if (std::fabs(x) < 0.01) {  // the next term, x^6 / 5040, is below the last place
    const double square = x * x;
    return 1.0 - square / 6.0 * (1.0 - square / 20.0);
  }
  return base::sin(x) / x;
}

/// The turn rate that the steering allows at this speed [rad/s].
double steeringLimit(const RobotBody& body, double speed) {
  if (body.kinematics != Kinematics::Ackermann) {
    return std::numeric_limits<double>::infinity();
  }
  return speed == 0.0 ? 0.0 : std::fabs(speed) / body.limits.turningRadius;
}

double withinEitherSpeed(double value, double limit) {
  return std::clamp(value, -limit, limit);
}

/// The speed nearest to the wanted one that differs from the present one by `change` at most.
double approachedSpeed(double now, double wanted, double change) {
  return std::clamp(wanted, now - change, now + change);
}

/// The turns that the steering leaves of the window: at its fastest no tighter ones, at its slowest
/// perhaps less than the drive alone could brake to.
void limitSteering(const RobotBody& body, TwistWindow& window) {
  const double low = std::fabs(window.lowLinear);
  const double high = std::fabs(window.highLinear);
  const bool canStand = window.lowLinear <= 0.0 && window.highLinear >= 0.0;
  const double fastest = steeringLimit(body, std::max(low, high));
  const double slowest = steeringLimit(body, canStand ? 0.0 : std::min(low, high));
  window.lowAngular = std::min(withinEitherSpeed(window.lowAngular, fastest), slowest);
  window.highAngular = std::max(withinEitherSpeed(window.highAngular, fastest), -slowest);
}

/// Way [m] of two components of velocity (both >= 0) that brake at the rate `deceleration` each:
/// the integral of the speed, while both are left and with what is left of the larger.
double wayOfBrakingBoth(double one, double other, double deceleration) {
  const double half = 0.5 * std::fabs(one - other);
  const double start = 0.5 * (one + other);  // goes down to `half` while both are left
  const double rest = 2.0 * half * half / deceleration;
  if (start == half) {
    return rest;
  }
  const double startSpeed = std::sqrt(start * start + half * half);
  const double endSpeed = std::sqrt(2.0) * half;
  double area = start * startSpeed - half * endSpeed;  // twice the integral of sqrt(s² + half²)
  if (half > 0.0) {
    area += half * half * base::log((start + startSpeed) / (half + endSpeed));
  }
  return area / (std::sqrt(2.0) * deceleration) + rest;
}

}  // namespace

Pose2 advanced(const Pose2& pose, const BodyTwist& twist, double time) {
  const double turn = twist.angular * time;
  const Pose2 middle{pose.position, pose.heading + 0.5 * turn};  // the chord's frame
  const Vec2 arc(twist.linear * time, twist.lateral * time);
  return {middle.toWorld(chordOverArc(0.5 * turn) * arc), base::wrapToPi(pose.heading + turn)};
}

BodyTwist feasible(const RobotBody& body, const BodyTwist& wanted) {
  const DriveLimits& limits = body.limits;
  BodyTwist twist;
  twist.linear = std::clamp(wanted.linear, -limits.maxReverse, limits.maxVel);
  if (body.kinematics == Kinematics::Omnidirectional) {
    twist.lateral = withinEitherSpeed(wanted.lateral, limits.maxVel);
  }
  const double steering = steeringLimit(body, twist.linear);
  twist.angular = withinEitherSpeed(wanted.angular, std::min(limits.maxOmega, steering));
  return twist;
}

BodyTwist reached(const RobotBody& body, const BodyTwist& now, const BodyTwist& wanted,
                  double time) {
  const BodyTwist target = feasible(body, wanted);
  const double change = body.limits.maxAcc * time;
  BodyTwist twist;
  twist.linear = approachedSpeed(now.linear, target.linear, change);
  if (body.kinematics == Kinematics::Omnidirectional) {
    twist.lateral = approachedSpeed(now.lateral, target.lateral, change);
  }
  twist.angular =
      withinEitherSpeed(approachedSpeed(now.angular, target.angular, body.limits.maxAlpha * time),
                        steeringLimit(body, twist.linear));
  return twist;
}

TwistWindow windowOf(const RobotBody& body, const BodyTwist& now, double time) {
  const DriveLimits& limits = body.limits;
  const double change = limits.maxAcc * time;
  const double turnChange = limits.maxAlpha * time;
  TwistWindow window;
  window.lowLinear = approachedSpeed(now.linear, -limits.maxReverse, change);
  window.highLinear = approachedSpeed(now.linear, limits.maxVel, change);
  if (body.kinematics == Kinematics::Omnidirectional) {
    window.lowLateral = approachedSpeed(now.lateral, -limits.maxVel, change);
    window.highLateral = approachedSpeed(now.lateral, limits.maxVel, change);
  }
  window.lowAngular = approachedSpeed(now.angular, -limits.maxOmega, turnChange);
  window.highAngular = approachedSpeed(now.angular, limits.maxOmega, turnChange);
  limitSteering(body, window);
  return window;
}

double brakingDistance(const RobotBody& body, const BodyTwist& twist) {
  const double ahead = std::fabs(twist.linear);
  const bool isOmni = body.kinematics == Kinematics::Omnidirectional;
  const double aside = isOmni ? std::fabs(twist.lateral) : 0.0;
  if (ahead == 0.0 && aside == 0.0) {
    return 0.0;
  }
  if (body.limits.maxAcc <= 0.0) {
    return std::numeric_limits<double>::infinity();
  }
  return wayOfBrakingBoth(ahead, aside, body.limits.maxAcc);
}

}  // namespace sim2d
