#include "sim2d/world/Sensing.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"

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

/// Calls visit(beam) for the beams that can meet a body, a beam to either side more.
template <class Visit>
void forEachBeamOn(const Pose2& sensor, const SeenBody& body, int beamCount, Visit visit) {
  const Vec2 toBody = body.position - sensor.position;
  const double distance = toBody.norm();
  const double perBeam = 2.0 * base::kPi / beamCount;
  if (distance <= body.radius) {
    for (int beam = 0; beam < beamCount; ++beam) {
      visit(beam);
    }
    return;
  }
  const double bearing = base::angleDiff(base::headingOf(toBody), sensor.heading);
  const double half = base::kPi / 2.0 - base::acos(body.radius / distance);
  const int first = static_cast<int>(std::floor((bearing - half) / perBeam)) - 1;
  const int last = static_cast<int>(std::ceil((bearing + half) / perBeam)) + 1;
  for (int beam = first; beam <= std::min(last, first + beamCount - 1); ++beam) {
    visit(((beam % beamCount) + beamCount) % beamCount);
  }
}

}  // namespace

Scan scan(const Pose2& sensor, const Obstacles& obstacles, const std::vector<SeenBody>& bodies,
          int beamCount, double range) {
  Scan result;
  result.range = range;
  std::vector<Vec2> directions;
  directions.reserve(static_cast<std::size_t>(beamCount));
  result.distances.reserve(static_cast<std::size_t>(beamCount));
  for (int beam = 0; beam < beamCount; ++beam) {
    const double turn = 2.0 * base::kPi * beam / beamCount;
    directions.push_back(base::directionOf(base::wrapToPi(sensor.heading + turn)));
    result.distances.push_back(obstacles.raycast(sensor.position, directions.back(), range));
  }
  for (const SeenBody& body : bodies) {
    if ((body.position - sensor.position).norm() - body.radius > range) {
      continue;
    }
    forEachBeamOn(sensor, body, beamCount, [&](int beam) {
      const auto at = static_cast<std::size_t>(beam);
      result.distances[at] = hitCircle(sensor.position, directions[at], body, result.distances[at]);
    });
  }
  return result;
}

}  // namespace sim2d
