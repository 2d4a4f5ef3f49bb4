#pragma once

#include <optional>

#include "sim2d/map/OccupancyGrid.h"

namespace editor {

/// The place on the border of the map's walls nearest to `world`, none beyond `reach` [m]: a corner
/// where there is one within reach, else anywhere on an edge. The steps that cells make along a
/// slanted wall are no corners. Looks only at the cells near by.
std::optional<base::Vec2> nearestOnWalls(const sim2d::OccupancyGrid& grid, const base::Vec2& world,
                                         double reach);

}  // namespace editor
