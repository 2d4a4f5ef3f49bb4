#include "sim2d/nav/Rollout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim2d/base/Math.h"

namespace sim2d {
namespace {

/// The angle in [0, 2 pi); what is below 0 by rounding alone is 0.
double wholeTurn(double angle) {
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
        to.push_back(feasible(body_, {linear, angular, lateral}));
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
    poses[i] = advanced(poses[i - 1], twist, step);
    // Not wrapped, so that poses between two can be mixed.
    poses[i].heading = poses[i - 1].heading + twist.angular * step;
  }
  if (i >= poses.size()) {
    return;
  }
  // From here on each step shifts and turns alike.
  const double turn = wanted.angular * step;
  const Vec2 shift = advanced(Pose2{}, wanted, step).position;
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

double stopTimeOf(const RobotBody& body, const BodyTwist& twist) {
  const double speed = std::max(std::fabs(twist.linear), std::fabs(twist.lateral));
  return std::max(speed / body.limits.maxAcc, std::fabs(twist.angular) / body.limits.maxAlpha);
}

double relaxedDubinsLength(double distance, double bearing, double turningRadius) {
  const double r = turningRadius;
  const double x = distance * base::cos(bearing);
  const double y = distance * std::fabs(base::sin(bearing));  // mirrored: it lies to the left
  const double fromLeft = std::sqrt(x * x + (y - r) * (y - r));
  if (fromLeft >= r) {
    const double straight = std::sqrt(fromLeft * fromLeft - r * r);
    const double ofPoint = base::atan2(y - r, x);
    return r * wholeTurn(ofPoint - base::acos(r / fromLeft) + 0.5 * base::kPi) + straight;
  }
  // To the right about the right centre first, then to the left about a circle that touches.
  const double fromRight = std::sqrt(x * x + (y + r) * (y + r));
  const double ofPoint = base::atan2(x, y + r);
  const double atRight = base::acos((3.0 * r * r + fromRight * fromRight) / (4.0 * r * fromRight));
  const double atLeft = base::acos((5.0 * r * r - fromRight * fromRight) / (4.0 * r * r));
  const double wide = wholeTurn(ofPoint + atRight) + 2.0 * base::kPi - atLeft;
  const double narrow = wholeTurn(ofPoint - atRight) + atLeft;
  return r * std::min(wide, narrow);
}

}  // namespace sim2d
