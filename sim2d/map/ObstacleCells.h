#pragma once

#include <vector>

#include "sim2d/base/Stop.h"
#include "sim2d/map/Obstacles.h"

namespace sim2d {

/// Marks of the cells of `grid` (row-major, 1 = marked) that enabled obstacles cover: those whose
/// centre is solid, and those an outline runs through unless they lie beside a wall of the map (so
/// that the map's own outlines do not thicken its walls). `isLarge`: without the map's own parts.
std::vector<char> cellsOfObstacles(const OccupancyGrid& grid, const Obstacles& obstacles,
                                   bool isLarge, const base::StopFlag& stop = {});

/// Marks of the wall cells of the map itself.
std::vector<char> cellsOfWalls(const OccupancyGrid& grid);

}  // namespace sim2d
