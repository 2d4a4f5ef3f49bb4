#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/Types.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"

/// The footprint of a robot as in Nav2 (nav2_costmap_2d, footprint.cpp).
namespace sim2d::nav2 {

using base::Pose2;
using base::Vec2;

using Polygon = std::vector<Vec2>;  // corners in clockwise or counter-clockwise order [m]

/// A circle around the origin as 16 corners, beginning on the x axis [m].
Polygon circlePolygon(double radius);
/// Moves each coordinate away from 0 by the padding; 0 is unchanged.
Polygon padded(const Polygon& polygon, double padding);
/// Transforms the polygon by a pose.
Polygon transformed(const Polygon& polygon, const Pose2& pose);

/// Parses "[[x, y], [x, y], …]" with at least three corners. Errors: invalid syntax, a corner that
/// is not a pair of numbers, fewer corners.
base::Result<Polygon> readPolygon(std::string_view text);

/// Minimum distance of the edges, and maximum distance of the corners, from the origin [m]; 0
/// without corners.
double inscribedRadius(const Polygon& polygon);
double circumscribedRadius(const Polygon& polygon);

/// The footprint of a robot in a costmap.
struct CostmapFootprint {
  Polygon corners;       // padded, robot frame [m]
  bool isRadius = true;  // given by a radius: the cost of the centre's cell determines a collision
  double inscribed = 0.0, circumscribed = 0.0;  // [m]
};
/// Uses the radius [m] if `corners` is empty.
CostmapFootprint costmapFootprint(double radius, const Polygon& corners, double padding);

/// Costs of the cells that a footprint covers (nav2_costmap_2d, footprint_collision_checker.cpp).

/// Visits the cells of a line in order, both ends included: Bresenham's algorithm with the error
/// starting at half of the longer side, as in nav2_util::LineIterator. Stops once `visit(Cell)` is
/// false.
template <class Visit>
void visitLine(Cell from, Cell to, Visit visit) {
  const int across = std::abs(to.column - from.column), up = std::abs(to.row - from.row);
  const int columnStep = to.column >= from.column ? 1 : -1, rowStep = to.row >= from.row ? 1 : -1;
  const bool isFlat = across >= up;
  const int longer = isFlat ? across : up, shorter = isFlat ? up : across;
  int error = longer / 2;
  Cell cell = from;
  for (int i = 0; i <= longer && visit(cell); ++i) {
    error += shorter;
    const bool isSideStep = error >= longer;
    error -= isSideStep ? longer : 0;
    cell.column += isFlat || isSideStep ? columnStep : 0;
    cell.row += !isFlat || isSideStep ? rowStep : 0;
  }
}

/// Cost of the cell at a position; 254 off the map (MPPI's CostCritic uses 255 there and must check
/// for itself).
std::uint8_t pointCost(const Costmap& costmap, const Vec2& place);
/// The maximum cost on a line, where 254 ranks above 255.
std::uint8_t lineCost(const Costmap& costmap, Cell from, Cell to);
/// The maximum cost on the edges of a polygon in world frame [m]; its interior is ignored. A corner
/// off the map: 254. As in Nav2 an edge of 255 before one of 254 hides it.
std::uint8_t polygonCost(const Costmap& costmap, const Polygon& polygon);
/// The same for a footprint at a pose.
std::uint8_t footprintCost(const Costmap& costmap, const Polygon& corners, const Pose2& pose);

/// Whether a cost on the edges of a polygon is a collision: 254, and 255 when unknown cells are
/// obstacles. 253 is not.
inline bool isEdgeCollision(std::uint8_t cost, bool isUnknownFree) {
  return cost == kLethal || (cost == kNoInformation && !isUnknownFree);
}
/// Whether the cost of the centre's cell is a collision for a round robot: >= 253.
inline bool isCentreCollision(std::uint8_t cost, bool isUnknownFree) {
  return cost == kNoInformation ? !isUnknownFree : cost >= kInscribed;
}
/// Nav2's usual test: the centre's cell for a robot with a radius, else the edges.
bool isInCollision(const Costmap& costmap, const CostmapFootprint& footprint, const Pose2& pose,
                   bool isUnknownFree);

}  // namespace sim2d::nav2
