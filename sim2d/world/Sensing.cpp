#include "sim2d/world/Sensing.h"

#include <algorithm>
#include <cmath>

namespace sim2d {
namespace {

/// Distance along the unit vector to the circle; `range` when it is missed.
double hitCircle(const Vec2& from, const Vec2& direction, const SeenBody& body, double range) {
  const Vec2 toCentre = body.position - from;
  const double along = toCentre.dot(direction);
  const double offset = base::cross(direction, toCentre);
  const double half = body.radius * body.radius - offset * offset;
  if (half < 0.0) {
    return range;
  }
  const double distance = along - std::sqrt(half);
  return distance >= 0.0 ? std::min(distance, range) : range;
}

}  // namespace

bool isInView(const Pose2& eye, const Vec2& point, double range, double halfAngle,
              const Obstacles& obstacles) {
  const Vec2 sight = point - eye.position;
  if (sight.norm() > range) {
    return false;
  }
  const double bearing = base::angleDiff(base::headingOf(sight), eye.heading);
  return std::fabs(bearing) <= halfAngle && obstacles.isVisible(eye.position, point);
}

Scan scan(const Pose2& sensor, const Obstacles& obstacles, const std::vector<SeenBody>& bodies,
          int beamCount, double range) {
  Scan result;
  result.range = range;
  result.distances.reserve(static_cast<std::size_t>(beamCount));
  for (int beam = 0; beam < beamCount; ++beam) {
    const double turn = 2.0 * base::kPi * beam / beamCount;
    const Vec2 direction = base::directionOf(base::wrapToPi(sensor.heading + turn));
    double distance = obstacles.raycast(sensor.position, direction, range);
    for (const SeenBody& body : bodies) {
      distance = hitCircle(sensor.position, direction, body, distance);
    }
    result.distances.push_back(distance);
  }
  return result;
}

}  // namespace sim2d
