#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim2d/base/Types.h"

namespace sim2d {

/// Costs of cells as a planner weighs them, for display. Axes are the world's; row-major from the
/// lower left. Values as in Nav2: 0 free, 1 … 252 near something, 253 a round robot would touch,
/// 254 an obstacle, 255 unknown.
struct CostGrid {
  int columns = 0, rows = 0;
  double resolution = 0.05;                // [m], side of a cell
  base::Vec2 origin = base::Vec2::Zero();  // lower left corner [m]
  std::vector<std::uint8_t> costs;         // columns * rows
};
using CostGridPtr = std::shared_ptr<const CostGrid>;

}  // namespace sim2d
