#include "sim2d/nav/VelocityPlanes.h"

#include <algorithm>
#include <cstddef>

#include "sim2d/base/Math.h"

namespace sim2d {
namespace {

constexpr std::size_t kMostVisible = 24;
constexpr double kWallSlack =
    2e-3;  // [m] that a wall always leaves, so that planes do not exclude zero

}  // namespace

std::vector<TrackedBody> visibleBodies(const Observation& observation, double range) {
  const Vec2& eye = observation.pose.position;
  const auto distance = [&eye](const TrackedBody& body) {
    return (body.position - eye).squaredNorm();
  };
  std::vector<TrackedBody> found;
  found.reserve(observation.bodies.size());
  for (const TrackedBody& body : observation.bodies) {
    if (distance(body) <= range * range &&
        (observation.navigation->isOpenBetween(eye, body.position) ||
         observation.obstacles->isVisible(eye, body.position))) {
      found.push_back(body);
    }
  }
  std::sort(found.begin(), found.end(), [&](const TrackedBody& a, const TrackedBody& b) {
    return distance(a) != distance(b) ? distance(a) < distance(b) : a.id < b.id;
  });
  if (found.size() > kMostVisible) {
    found.resize(kMostVisible);
  }
  return found;
}

std::vector<HalfPlane> wallPlanes(const Observation& observation, double radius, double speed,
                                  double horizon) {
  std::vector<Obstacles::Point> points;
  const Vec2& position = observation.pose.position;
  observation.obstacles->boundaryPoints(position, points, radius + speed * horizon);
  std::vector<HalfPlane> planes;
  planes.reserve(points.size());
  for (const Obstacles::Point& point : points) {
    const double size = point.inside ? radius : std::min(radius, point.distance - kWallSlack);
    planes.push_back(
        avoidPoint(Walker(0, position, Vec2::Zero(), size), point, horizon, observation.dt));
  }
  return planes;
}

Vec2 turnedBy(const Vec2& vector, double angle) {
  const double cosine = base::cos(angle);
  const double sine = base::sin(angle);
  return {cosine * vector.x() - sine * vector.y(), sine * vector.x() + cosine * vector.y()};
}

HalfPlane turnedBy(const HalfPlane& plane, double heading) {
  return {turnedBy(plane.point, heading), turnedBy(plane.direction, heading)};
}

double worstViolation(const std::vector<HalfPlane>& planes, std::size_t first,
                      const Vec2& velocity) {
  double worst = 0.0;
  for (std::size_t i = first; i < planes.size(); ++i) {
    worst = std::max(worst, planes[i].violation(velocity));
  }
  return worst;
}

}  // namespace sim2d
