#pragma once

#include <optional>
#include <vector>

#include "sim2d/base/Stop.h"
#include "sim2d/map/OccupancyGrid.h"

namespace sim2d {

/// A straight piece of an outline [m]. The solid lies on its left.
struct Segment {
  Vec2 a = Vec2::Zero();
  Vec2 b = Vec2::Zero();
};

/// Without points that lie on the one before, to a nanometre.
std::vector<Vec2> withoutRepeats(const std::vector<Vec2>& line);

Vec2 closestOnSegment(const Segment& segment, const Vec2& point);
double distanceToSegment(const Segment& segment, const Vec2& point);  // [m]

/// The two share at least one point; ends count.
bool segmentsTouch(const Segment& first, const Segment& second);
/// The second, which starts where the first ends, runs straight back over it.
bool isSpike(const Segment& first, const Segment& second);

/// Distance [m] along the unit vector `direction` to the segment, widened by a nanometre at its
/// ends so that no ray slips between two neighbours. None behind the origin or for parallel lines.
std::optional<double> raySegmentHit(const Vec2& from, const Vec2& direction,
                                    const Segment& segment);

/// One closed boundary between solid and free, world frame [m]. The solid lies to the LEFT of each
/// edge: the border of a block runs counter-clockwise, the border of a room inside walls clockwise.
/// The last point joins the first.
struct Outline {
  std::vector<Vec2> points;
  friend bool operator==(const Outline& a, const Outline& b) { return a.points == b.points; }
};

/// Borders of the wall cells of a map, simplified to within half a cell, still closed and simple.
std::vector<Outline> traceOutlines(const OccupancyGrid& grid, const base::StopFlag& stop = {});

/// Border of drawn shapes (desktop-block: box, circle, polygon, wall, door), solid on the left.
Outline boxOutline(const Pose2& centre, double length, double width);
Outline circleOutline(const Vec2& centre, double radius, int corners = 32);
Outline polygonOutline(std::vector<Vec2> points);  // turned counter-clockwise if need be
/// A polyline with a thickness, as a union of simple outlines.
std::vector<Outline> wallOutlines(const std::vector<Vec2>& line, double thickness);

double signedArea(const std::vector<Vec2>& polygon);  // > 0: counter-clockwise
bool isInside(const std::vector<Vec2>& polygon, const Vec2& point);
bool isSimple(const std::vector<Vec2>& polygon);  // no edge crosses another

}  // namespace sim2d
