#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/map/OccupancyGrid.h"

namespace sim2d {

/// Cells of a grid with nearest-neighbour queries from any position, in time that grows with the
/// logarithm of their number: a tree of bounding boxes. Immutable after build and thread-safe.
class BorderCells {
 public:
  /// Neighbours in the list should be near each other.
  void build(std::vector<Cell> cells);

  /// [cells] from a position to the nearest square; infinity if there are no cells. `examined`: is
  /// increased by the number of cells and boxes whose distances were computed.
  double distance(const Vec2& corner, std::size_t* examined = nullptr) const;
  std::size_t size() const { return cells_.size(); }
  std::size_t bytes() const;

 private:
  struct Box {
    Cell low, high;
  };
  struct Search;

  std::vector<Cell> cells_;
  std::vector<std::vector<Box>> levels_;  // each box is that of several of the level before
};

}  // namespace sim2d
