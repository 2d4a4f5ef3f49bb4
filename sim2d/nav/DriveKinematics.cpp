#include "sim2d/nav/DriveKinematics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "sim2d/base/Math.h"

namespace sim2d {
namespace {

/// sin(x) / x: chord length over arc length, where x is half the angle of the arc.
double chordOverArc(double x) {
  if (std::fabs(x) < 0.01) {  // the next term, x^6 / 5040, is below machine precision
    const double square = x * x;
    return 1.0 - square / 6.0 * (1.0 - square / 20.0);
  }
  return base::sin(x) / x;
}

/// Maximum turn rate of the steering at this speed [rad/s].
double steeringLimit(const RobotBody& body, double speed) {
  if (body.kinematics != Kinematics::Ackermann) {
    return std::numeric_limits<double>::infinity();
  }
  return speed == 0.0 ? 0.0 : std::fabs(speed) / body.limits.turningRadius;
}

double clampSymmetric(double value, double limit) {
  return std::clamp(value, -limit, limit);
}

/// The speed nearest to the wanted one that differs from the current one by at most `change`.
double rateLimited(double now, double wanted, double change) {
  return std::clamp(wanted, now - change, now + change);
}

/// Reduces the turn rates of the window to those that the steering allows at its highest and lowest
/// speed.
void limitSteering(const RobotBody& body, TwistWindow& window) {
  const double low = std::fabs(window.lowLinear);
  const double high = std::fabs(window.highLinear);
  const bool canStand = window.lowLinear <= 0.0 && window.highLinear >= 0.0;
  const double fastest = steeringLimit(body, std::max(low, high));
  const double slowest = steeringLimit(body, canStand ? 0.0 : std::min(low, high));
  window.lowAngular = std::min(clampSymmetric(window.lowAngular, fastest), slowest);
  window.highAngular = std::max(clampSymmetric(window.highAngular, fastest), -slowest);
}

}  // namespace

Pose2 propagated(const Pose2& pose, const BodyTwist& twist, double time) {
  const double turn = twist.angular * time;
  const Pose2 middle{pose.position, pose.heading + 0.5 * turn};  // frame of the chord
  const Vec2 arc(twist.linear * time, twist.lateral * time);
  return {middle.toWorld(chordOverArc(0.5 * turn) * arc), base::wrapToPi(pose.heading + turn)};
}

BodyTwist clampedToLimits(const RobotBody& body, const BodyTwist& wanted) {
  const DriveLimits& limits = body.limits;
  BodyTwist twist;
  twist.linear = std::clamp(wanted.linear, -limits.maxReverse, limits.maxVel);
  if (body.kinematics == Kinematics::Omnidirectional) {
    twist.lateral = clampSymmetric(wanted.lateral, limits.maxVel);
  }
  const double steering = steeringLimit(body, twist.linear);
  twist.angular = clampSymmetric(wanted.angular, std::min(limits.maxOmega, steering));
  return twist;
}

BodyTwist reached(const RobotBody& body, const BodyTwist& now, const BodyTwist& wanted,
                  double time) {
  const BodyTwist target = clampedToLimits(body, wanted);
  const double change = body.limits.maxAcc * time;
  BodyTwist twist;
  twist.linear = rateLimited(now.linear, target.linear, change);
  if (body.kinematics == Kinematics::Omnidirectional) {
    twist.lateral = rateLimited(now.lateral, target.lateral, change);
  }
  twist.angular =
      clampSymmetric(rateLimited(now.angular, target.angular, body.limits.maxAlpha * time),
                     steeringLimit(body, twist.linear));
  return twist;
}

TwistWindow dynamicWindow(const RobotBody& body, const BodyTwist& now, double time) {
  const DriveLimits& limits = body.limits;
  const double change = limits.maxAcc * time;
  const double turnChange = limits.maxAlpha * time;
  TwistWindow window;
  window.lowLinear = rateLimited(now.linear, -limits.maxReverse, change);
  window.highLinear = rateLimited(now.linear, limits.maxVel, change);
  if (body.kinematics == Kinematics::Omnidirectional) {
    window.lowLateral = rateLimited(now.lateral, -limits.maxVel, change);
    window.highLateral = rateLimited(now.lateral, limits.maxVel, change);
  }
  window.lowAngular = rateLimited(now.angular, -limits.maxOmega, turnChange);
  window.highAngular = rateLimited(now.angular, limits.maxOmega, turnChange);
  limitSteering(body, window);
  return window;
}

namespace {

/// The angle in [0, 2 pi); values below 0 by rounding become 0.
double wrapToTwoPi(double angle) {
  constexpr double kRounding = 1e-9;
  double turn = base::wrapToPi(angle);
  if (turn < 0.0) {
    turn = turn > -kRounding ? 0.0 : turn + 2.0 * base::kPi;
  }
  return turn;
}

}  // namespace

void sampleEvenly(double low, double high, int count, std::vector<double>& to) {
  to.clear();
  to.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.5;
    to.push_back(low + share * (high - low));
  }
  if (low < 0.0 && high > 0.0) {
    *std::min_element(to.begin(), to.end(),
                      [](double a, double b) { return std::fabs(a) < std::fabs(b); }) = 0.0;
  }
}

SampleCounts sampleCounts(Kinematics kinematics, int linear, int angular) {
  if (kinematics != Kinematics::Omnidirectional) {
    return {linear, angular, 1};
  }
  int each = 1;
  while ((each + 1) * (each + 1) * (each + 1) <= linear * angular) {
    ++each;
  }
  return {each, each, each};
}

TwistSampler::TwistSampler(const RobotBody& body, const SampleCounts& counts)
    : body_(body), counts_(counts) {}

void TwistSampler::sample(const TwistWindow& window, std::vector<BodyTwist>& to) {
  to.clear();
  to.reserve(static_cast<std::size_t>(counts_.linear) * static_cast<std::size_t>(counts_.angular) *
             static_cast<std::size_t>(counts_.lateral));
  sampleEvenly(window.lowLinear, window.highLinear, counts_.linear, linear_);
  sampleEvenly(window.lowLateral, window.highLateral, counts_.lateral, lateral_);
  for (const double linear : linear_) {
    double low = window.lowAngular;
    double high = window.highAngular;
    if (body_.kinematics == Kinematics::Ackermann) {
      const double radius = std::max(body_.limits.turningRadius, 1e-9);
      const double most = std::fabs(linear) / radius;
      low = std::clamp(low, -most, most);
      high = std::clamp(high, -most, most);
    }
    sampleEvenly(low, high, counts_.angular, angular_);
    for (const double angular : angular_) {
      for (const double lateral : lateral_) {
        to.push_back(clampedToLimits(body_, {linear, angular, lateral}));
      }
    }
  }
}

void rollOut(const RobotBody& body, const Pose2& from, const BodyTwist& now,
             const BodyTwist& wanted, double step, std::vector<Pose2>& poses) {
  poses.front() = from;
  BodyTwist twist = now;
  std::size_t i = 1;
  for (; i < poses.size() && twist != wanted; ++i) {
    twist = reached(body, twist, wanted, step);
    poses[i] = propagated(poses[i - 1], twist, step);
    // Not wrapped, so that poses can be interpolated.
    poses[i].heading = poses[i - 1].heading + twist.angular * step;
  }
  if (i >= poses.size()) {
    return;
  }
  // From here on each step has the same translation and rotation.
  const double turn = wanted.angular * step;
  const Vec2 shift = propagated(Pose2{}, wanted, step).position;
  const Vec2 turned = base::directionOf(turn);
  Vec2 direction = poses[i - 1].direction();
  for (; i < poses.size(); ++i) {
    const Pose2& before = poses[i - 1];
    poses[i].position =
        before.position + Vec2(direction.x() * shift.x() - direction.y() * shift.y(),
                               direction.y() * shift.x() + direction.x() * shift.y());
    poses[i].heading = before.heading + turn;
    direction = Vec2(direction.x() * turned.x() - direction.y() * turned.y(),
                     direction.y() * turned.x() + direction.x() * turned.y());
  }
}

double stoppingTime(const RobotBody& body, const BodyTwist& twist) {
  const double speed = std::max(std::fabs(twist.linear), std::fabs(twist.lateral));
  return std::max(speed / body.limits.maxAcc, std::fabs(twist.angular) / body.limits.maxAlpha);
}

double relaxedDubinsLength(double distance, double bearing, double turningRadius) {
  const double r = turningRadius;
  const double x = distance * base::cos(bearing);
  const double y = distance * std::fabs(base::sin(bearing));  // mirrored to the left
  const double fromLeft = std::sqrt(x * x + (y - r) * (y - r));
  if (fromLeft >= r) {
    const double straight = std::sqrt(fromLeft * fromLeft - r * r);
    const double ofPoint = base::atan2(y - r, x);
    return r * wrapToTwoPi(ofPoint - base::acos(r / fromLeft) + 0.5 * base::kPi) + straight;
  }
  // A right arc first, then a left arc about a circle tangent to it.
  const double fromRight = std::sqrt(x * x + (y + r) * (y + r));
  const double ofPoint = base::atan2(x, y + r);
  const double atRight = base::acos((3.0 * r * r + fromRight * fromRight) / (4.0 * r * fromRight));
  const double atLeft = base::acos((5.0 * r * r - fromRight * fromRight) / (4.0 * r * r));
  const double wide = wrapToTwoPi(ofPoint + atRight) + 2.0 * base::kPi - atLeft;
  const double narrow = wrapToTwoPi(ofPoint - atRight) + atLeft;
  return r * std::min(wide, narrow);
}

}  // namespace sim2d
