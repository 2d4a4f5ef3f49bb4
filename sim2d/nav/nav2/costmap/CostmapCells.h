#pragma once

#include <cstdint>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

/// Operations on grids that layers share (nav2_costmap_2d, costmap_2d.cpp, costmap_layer.cpp).
namespace sim2d::nav2 {

/// Width and height as Nav2 measures them: (cells - 1/2) * resolution [m].
Vec2 nav2SizeOf(const Costmap& costmap);
/// The lower left corner is moved towards `origin` by whole cells, rounded towards 0; cells that
/// stay inside keep their costs, the others become `fresh`.
void moveOrigin(Costmap& costmap, const Vec2& origin, std::uint8_t fresh);
/// The cell of a place, or the one at the border that is nearest by each axis.
Cell nearestCell(const Costmap& costmap, const Vec2& place);
/// The cells of the bounds; empty when they hold none.
CellWindow windowOf(const Costmap& costmap, const CostmapBounds& bounds);
inline CellWindow wholeWindow(const Costmap& costmap) {
  return {0, 0, costmap.width(), costmap.height()};
}

void fillWindow(Costmap& costmap, const CellWindow& window, std::uint8_t cost);
/// Ways to merge a grid into one of equal size (combination_method 0, 1, 2, and a true copy).
enum class Merge : std::uint8_t { Overwrite, Maximum, MaximumOfKnown, Copy };
void mergeWindow(const Costmap& from, const CellWindow& window, Merge way, Costmap& into);

/// The cells of a convex polygon in world frame, borders included; nothing when a corner lies off
/// the map.
void fillPolygon(Costmap& costmap, const Polygon& polygon, std::uint8_t cost);

}  // namespace sim2d::nav2
