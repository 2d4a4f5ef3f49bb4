#pragma once

#include <vector>

#include "sim2d/map/Obstacles.h"

namespace sim2d {

/// Marks of the cells of `grid` (row-major, 1 = marked) that enabled obstacles cover: those whose
/// centre is solid, and those an outline runs through unless they lie beside a wall of the map (so
/// that the map's own outlines do not thicken its walls).
std::vector<char> cellsOfObstacles(const OccupancyGrid& grid, const Obstacles& obstacles);

/// Marks of the wall cells of the map itself.
std::vector<char> cellsOfWalls(const OccupancyGrid& grid);

/// A free grid over the points and all outlines, with a margin of 3 m.
OccupancyGrid gridOver(const Obstacles& obstacles, const std::vector<Vec2>& points);

}  // namespace sim2d
