#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "sim2d/base/Types.h"

/// Grids of planners for display.
namespace sim2d {

/// A planner's costmap, for display. Axes of the world frame; row-major from the lower left. Values
/// as in Nav2: 0 free, 1 … 252 inflated, 253 inscribed, 254 lethal, 255 unknown.
struct CostGrid {
  int columns = 0, rows = 0;
  double resolution = 0.05;                // [m], cell size
  base::Vec2 origin = base::Vec2::Zero();  // lower left corner [m]
  std::vector<std::uint8_t> costs;         // columns * rows
};
using CostGridPtr = std::shared_ptr<const CostGrid>;

/// The mask of a costmap filter, for display. Values are percentages: how far a cell is kept out
/// (100: lethal), the speed limit relative to the top speed, or 100 where a switch is flipped; 0:
/// no effect.
struct MaskGrid {
  enum class Kind : std::uint8_t { Keepout, Speed, Switch };
  MaskGrid(Kind itsKind, CostGridPtr itsGrid) : kind(itsKind), grid(std::move(itsGrid)) {
    for (const std::uint8_t percent : grid->costs) {
      least = percent > 0 && (least == 0 || percent < least) ? percent : least;
      most = percent > most ? percent : most;
    }
  }

  Kind kind;
  CostGridPtr grid;
  std::uint8_t least = 0, most = 0;  // of the values above 0
  friend bool operator==(const MaskGrid& a, const MaskGrid& b) {
    return a.kind == b.kind && a.grid->origin == b.grid->origin &&
           a.grid->resolution == b.grid->resolution && a.grid->columns == b.grid->columns &&
           a.grid->costs == b.grid->costs;
  }
};

}  // namespace sim2d
