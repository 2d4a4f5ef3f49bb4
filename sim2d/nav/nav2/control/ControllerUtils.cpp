#include "sim2d/nav/nav2/control/ControllerUtils.h"

#include <algorithm>
#include <cmath>

namespace sim2d::nav2 {

double rotationVelocity(const RotationLimits& turn, double angle, double now, double dt) {
  const double sign = angle > 0.0 ? 1.0 : -1.0;
  const double acceleration = std::max(turn.angularAcceleration, 0.0);
  const double change = acceleration * dt;
  const double reached = std::clamp(sign * turn.angularVelocity, now - change, now + change);
  const double brakable = std::sqrt(2.0 * acceleration * std::abs(angle));
  return std::abs(reached) > brakable ? sign * brakable : reached;
}

}  // namespace sim2d::nav2
