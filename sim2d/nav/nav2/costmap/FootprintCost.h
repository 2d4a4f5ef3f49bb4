#pragma once

#include <cstdint>
#include <cstdlib>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

/// What a footprint touches in a costmap (nav2_costmap_2d, footprint_collision_checker.cpp).
namespace sim2d::nav2 {

/// Visits the cells of a line in order, both ends included: Bresenham's with the error starting at
/// half of the longer side, as nav2_util::LineIterator has it. Stops once `visit(Cell)` is false.
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

/// Of the cell of a place; 254 off the map (CostCritic of MPPI takes 255 there: ask the map).
std::uint8_t placeCost(const Costmap& costmap, const Vec2& place);
/// The greatest cost on a line, where 254 is greater than 255.
std::uint8_t lineCost(const Costmap& costmap, Cell from, Cell to);
/// The greatest cost on the edges; of a polygon in world frame [m]. The inside is not looked at. A
/// corner off the map: 254. As in Nav2 an edge of 255 before one of 254 hides it.
std::uint8_t polygonCost(const Costmap& costmap, const Polygon& polygon);
/// The same of the footprint at a pose.
std::uint8_t footprintCost(const Costmap& costmap, const Polygon& corners, const Pose2& pose);

/// Whether a cost on the edges of a polygon means a collision: 254, and 255 when unknown cells are
/// obstacles. 253 does not.
inline bool isEdgeCollision(std::uint8_t cost, bool isUnknownFree) {
  return cost == kLethal || (cost == kNoInformation && !isUnknownFree);
}
/// Whether a cost of the centre's cell means a collision of a round robot: from 253 on.
inline bool isCentreCollision(std::uint8_t cost, bool isUnknownFree) {
  return cost == kNoInformation ? !isUnknownFree : cost >= kInscribed;
}
/// Nav2's usual test: the centre alone for a robot with a radius, else the edges.
bool isInCollision(const Costmap& costmap, const CostmapFootprint& footprint, const Pose2& pose,
                   bool isUnknownFree);

}  // namespace sim2d::nav2
