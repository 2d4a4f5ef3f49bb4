#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/Types.h"
#include "sim2d/nav/Body.h"

/// The outline of a robot as Nav2 has it (nav2_costmap_2d, footprint.cpp).
namespace sim2d::nav2 {

using base::Pose2;
using base::Vec2;

using Polygon = std::vector<Vec2>;  // corners in order, either way round [m]

/// A circle about the origin by 16 corners, the first one on the x axis [m].
Polygon circlePolygon(double radius);
/// Each coordinate moved away from 0 by the padding; a coordinate that is 0 stays.
Polygon padded(const Polygon& polygon, double padding);
/// At a pose.
Polygon placed(const Polygon& polygon, const Pose2& pose);

/// "[[x, y], [x, y], …]" with at least three corners. Errors: another text, a corner that is no
/// pair of numbers, fewer corners.
base::Result<Polygon> readPolygon(std::string_view text);
/// The other way round: "[[0.1, -0.2], …]".
std::string polygonText(const Polygon& polygon);

/// Least distance of the corners and edges from the origin, and the greatest of the corners [m];
/// nothing for no corners.
double inscribedRadius(const Polygon& polygon);
double circumscribedRadius(const Polygon& polygon);

/// A robot in a costmap.
struct CostmapFootprint {
  Polygon corners;       // padded, robot frame [m]
  bool isRadius = true;  // given by a radius: the cost of the centre's cell tells a collision
  double inscribed = 0.0, circumscribed = 0.0;  // [m]
};
/// Without corners by the radius [m].
CostmapFootprint costmapFootprint(double radius, const Polygon& corners, double padding);

}  // namespace sim2d::nav2
