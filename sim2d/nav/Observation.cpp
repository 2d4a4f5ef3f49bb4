#include "sim2d/nav/Observation.h"

#include <cmath>

namespace sim2d {

bool isInView(const Pose2& eye, const Vec2& point, double range, double halfAngle,
              const Obstacles& obstacles) {
  const Vec2 sight = point - eye.position;
  if (sight.norm() > range) {
    return false;
  }
  const double bearing = base::angleDiff(base::headingOf(sight), eye.heading);
  return std::fabs(bearing) <= halfAngle && obstacles.isVisible(eye.position, point);
}

}  // namespace sim2d
