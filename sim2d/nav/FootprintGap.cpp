#include "sim2d/nav/FootprintGap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "sim2d/map/Outlines.h"

namespace sim2d {
namespace {

Segment footprintEdge(const std::vector<Vec2>& corners, std::size_t index) {
  return {corners[index], corners[index + 1 < corners.size() ? index + 1 : 0]};
}

/// Distance from a point to the polygon's boundary [m].
double distanceToEdges(const std::vector<Vec2>& corners, const Vec2& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 closest = closestOnSegment(footprintEdge(corners, i), point);
    least = std::min(least, (closest - point).squaredNorm());
  }
  return std::sqrt(least);
}

/// Same, negative inside.
double signedDistanceToEdges(const std::vector<Vec2>& corners, const Vec2& point) {
  const double distance = distanceToEdges(corners, point);
  return isInside(corners, point) ? -distance : distance;
}

/// Next intersection of the wall with the polygon's boundary, as a fraction of the wall's length; 1
/// if none. Intersections slightly beyond the end of an edge count too; an extra one does no harm.
double nextIntersection(const std::vector<Vec2>& corners, const Segment& wall, double after) {
  constexpr double kBeside = 1e-9;
  const Vec2 along = wall.b - wall.a;
  double next = 1.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Segment edge = footprintEdge(corners, i);
    const Vec2 side = edge.b - edge.a;
    const double slope = base::cross(along, side);
    if (slope == 0.0) {
      continue;  // parallel: the neighbouring edges intersect it
    }
    const double onWall = base::cross(edge.a - wall.a, side) / slope;
    const double onEdge = base::cross(edge.a - wall.a, along) / slope;
    if (onWall > after && onWall < next && onEdge >= -kBeside && onEdge <= 1.0 + kBeside) {
      next = onWall;
    }
  }
  return next;
}

/// Largest depth inside the polygon [m] of the midpoints of the wall's pieces; 0 if none is inside.
double wallDepth(const std::vector<Vec2>& corners, const Segment& wall) {
  double depth = 0.0;
  double from = 0.0;
  while (from < 1.0) {
    const double to = nextIntersection(corners, wall, from);
    const Vec2 middle = wall.a + 0.5 * (from + to) * (wall.b - wall.a);
    if (isInside(corners, middle)) {
      depth = std::max(depth, distanceToEdges(corners, middle));
    }
    from = to;
  }
  return depth;
}

/// Distance of two segments that do not touch [m].
double disjointSegmentDistance(const Segment& one, const Segment& other) {
  return std::min({distanceToSegment(one, other.a), distanceToSegment(one, other.b),
                   distanceToSegment(other, one.a), distanceToSegment(other, one.b)});
}

/// Gap between a polygon and one wall, both in robot frame.
double gapToWall(const std::vector<Vec2>& corners, const Segment& wall) {
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Segment edge = footprintEdge(corners, i);
    if (segmentsTouch(edge, wall)) {
      return -wallDepth(corners, wall);
    }
    gap = std::min(gap, disjointSegmentDistance(edge, wall));
  }
  return isInside(corners, wall.a) ? -wallDepth(corners, wall) : gap;
}

/// Minimum gap to the boundaries within `range` of the robot's origin; `limit` if none is smaller.
double gapToBorders(const Footprint& footprint, const Pose2& pose, const Obstacles& obstacles,
                    double range, double limit) {
  thread_local std::vector<Segment> walls;
  walls.clear();
  obstacles.segmentsNear(pose.position, range, walls);
  const double reach = circumscribedRadius(footprint);
  const Vec2 ahead = pose.direction();
  const auto toLocal = [&](const Vec2& point) {
    const Vec2 offset = point - pose.position;
    return Vec2(ahead.dot(offset), base::cross(ahead, offset));
  };
  double gap = limit;
  for (const Segment& wall : walls) {
    // The gap is at least the distance from the origin minus the circumscribed radius.
    if (distanceToSegment(wall, pose.position) - reach < gap) {
      gap = std::min(gap, gapToWall(footprint.corners, {toLocal(wall.a), toLocal(wall.b)}));
    }
  }
  return gap;
}

double gapOfPolygon(const Footprint& footprint, const Pose2& pose, const Obstacles& obstacles,
                    double limit) {
  const double reach = circumscribedRadius(footprint);
  const double clearance = obstacles.clearance(pose.position, limit + reach);
  if (clearance >= limit + reach) {
    return limit;
  }
  // The boundary nearest to the origin has a gap of at most `nearest` to the footprint.
  const double inner = -signedDistanceToEdges(footprint.corners, Vec2::Zero());
  const double nearest = std::clamp(std::fabs(clearance) - inner, 0.0, limit);
  double gap = gapToBorders(footprint, pose, obstacles, reach + nearest, limit);
  if (inner > 0.0 && clearance < 0.0) {
    gap = std::min(gap, clearance - inner);
  }
  if (inner <= 0.0) {  // any point of the footprint decides whether all of it is inside
    const double depth =
        -obstacles.clearance(pose.toWorld(footprint.corners.front()), limit + reach);
    gap = depth > 0.0 ? std::min(gap, -depth) : gap;
  }
  return gap;
}

}  // namespace

double inscribedRadius(const Footprint& footprint) {
  if (footprint.isDisc()) {
    return footprint.radius;
  }
  return std::max(0.0, -signedDistanceToEdges(footprint.corners, Vec2::Zero()));
}

double gapToDisc(const Footprint& footprint, const Pose2& pose, const Vec2& centre, double radius) {
  if (footprint.isDisc()) {
    return (centre - pose.position).norm() - footprint.radius - radius;
  }
  return signedDistanceToEdges(footprint.corners, pose.toLocal(centre)) - radius;
}

OutlineDirections outlineDirections(double heading) {
  OutlineDirections directions;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const double turn = 2.0 * base::kPi * static_cast<double>(k) / double(directions.size());
    directions[k] = base::directionOf(base::wrapToPi(heading + turn));
  }
  return directions;
}

std::vector<Vec2> inflatedOutline(const Footprint& footprint, const Pose2& pose, double distance,
                                  const OutlineDirections& directions) {
  const double radius =
      (distance + (footprint.isDisc() ? footprint.radius : 0.0)) * kOutlineInflation;
  const std::vector<Vec2> middles =
      footprint.isDisc() ? std::vector<Vec2>{Vec2::Zero()} : footprint.corners;
  std::vector<Vec2> points;
  points.reserve(middles.size() * directions.size());
  for (const Vec2& middle : middles) {
    const Vec2 centre = pose.toWorld(middle);
    for (const Vec2& direction : directions) {
      points.emplace_back(centre + radius * direction);
    }
  }
  return convexHull(std::move(points));
}

double gapToWalls(const Footprint& footprint, const Pose2& pose, const Obstacles& obstacles,
                  double limit) {
  if (footprint.isDisc()) {
    const double range = limit + footprint.radius;
    const double clearance = obstacles.clearance(pose.position, range);
    return clearance < range ? clearance - footprint.radius : limit;
  }
  return gapOfPolygon(footprint, pose, obstacles, limit);
}

}  // namespace sim2d
