#include "sim2d/nav/nav2/control/DynamicWindowPursuit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace sim2d::nav2 {
namespace {

struct WindowAxis {
  double least, most;   // [m/s] or [rad/s]
  double acceleration;  // > 0
  double deceleration;  // < 0
};

/// Least and greatest velocity that can be reached.
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
