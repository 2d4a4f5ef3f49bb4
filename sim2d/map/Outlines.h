#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim2d/base/StopFlag.h"
#include "sim2d/base/Types.h"
#include "sim2d/map/OccupancyGrid.h"

namespace sim2d {

/// A straight edge of an outline [m]. The solid lies on its left.
struct Segment {
  Vec2 a = Vec2::Zero();
  Vec2 b = Vec2::Zero();
};

/// Removes points that coincide with the previous one (to a nanometre).
std::vector<Vec2> withoutRepeats(const std::vector<Vec2>& line);

Vec2 closestOnSegment(const Segment& segment, const Vec2& point);
double distanceToSegment(const Segment& segment, const Vec2& point);  // [m]

/// Smallest distance between two segments [m].
double distanceBetween(const Segment& first, const Segment& second);
/// Whether the segments share a point, end points included.
bool segmentsTouch(const Segment& first, const Segment& second);
/// Whether the second, which starts at the end of the first, runs back over it.
bool isSpike(const Segment& first, const Segment& second);

/// Distance [m] along the unit vector `direction` to the segment, which is extended by a nanometre
/// at both ends so that no ray passes between adjacent segments. None behind the origin and for
/// parallel lines.
std::optional<double> raySegmentHit(const Vec2& from, const Vec2& direction,
                                    const Segment& segment);

/// A closed boundary between solid and free, world frame [m]. The solid lies to the LEFT of each
/// edge: the border of a block runs counter-clockwise, that of a room clockwise. The last point
/// connects to the first.
struct Outline {
  std::vector<Vec2> points;
  friend bool operator==(const Outline& a, const Outline& b) { return a.points == b.points; }
};

/// Borders of the wall cells of a map, simplified to within half a cell; closed and simple.
std::vector<Outline> traceOutlines(const OccupancyGrid& grid, const base::StopFlag& stop = {});

/// Borders of drawn shapes (box, circle, polygon, wall, door), solid on the left.
Outline boxOutline(const Pose2& centre, double length, double width);
Outline circleOutline(const Vec2& centre, double radius, int corners = 32);
Outline polygonOutline(std::vector<Vec2> points);  // reversed if clockwise
/// A polyline with a thickness, as a union of simple outlines.
std::vector<Outline> wallOutlines(const std::vector<Vec2>& line, double thickness);

double signedArea(const std::vector<Vec2>& polygon);  // > 0: counter-clockwise
bool isInside(const std::vector<Vec2>& polygon, const Vec2& point);
bool isSimple(const std::vector<Vec2>& polygon);  // no edge crosses another

/// Convex polygons, counter-clockwise, and paths around them. World frame [m]. Thread-safe.

using base::Vec2;

/// The convex hull without collinear points.
std::vector<Vec2> convexHull(std::vector<Vec2> points);

/// Where a line segment enters a convex polygon.
struct PolygonEntry {
  double share = 0.0;    // fraction of the segment, 0 to 1; 0: it begins inside
  std::size_t edge = 0;  // index of its first corner; beginning inside: of the nearest edge
};
/// None: the segment misses the polygon or only touches its border.
std::optional<PolygonEntry> entryPoint(const std::vector<Vec2>& polygon, const Vec2& from,
                                       const Vec2& to);

/// The two shortest paths around a convex polygon, including `from` and `to`: `left` passes with
/// the polygon on its right, `right` with the polygon on its left. Both are empty if the straight
/// line does not cross the polygon or an end lies inside.
struct PathsAround {
  std::vector<Vec2> left, right;
};
PathsAround pathsAround(const std::vector<Vec2>& polygon, const Vec2& from, const Vec2& to);

}  // namespace sim2d
