#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "sim2d/base/Types.h"

namespace sim2d {

using base::Pose2;
using base::Vec2;

/// Column and row of a cell, from the lower left of the map.
struct Cell {
  int column = 0;
  int row = 0;
  friend bool operator==(Cell a, Cell b) { return a.column == b.column && a.row == b.row; }
  friend bool operator!=(Cell a, Cell b) { return !(a == b); }
};

/// A Nav2 occupancy grid. Values: 100 occupied, 0 free, -1 unknown, 1..99 probability. Row-major
/// from the lower left. A grid without cells is the open plane: free everywhere. Outside the grid
/// is free. Immutable and thread-safe; copies share the cells.
class OccupancyGrid {
 public:
  OccupancyGrid() = default;  // open plane
  /// `cells`: width * height values; `resolution` [m] > 0; `origin`: pose of the lower left corner
  /// of the lower left cell.
  OccupancyGrid(int width, int height, double resolution, Pose2 origin,
                std::vector<std::int8_t> cells);

  int width() const { return width_; }
  int height() const { return height_; }
  double resolution() const { return resolution_; }
  const Pose2& origin() const { return origin_; }
  bool isEmpty() const { return width_ == 0; }
  const std::vector<std::int8_t>& cells() const;

  bool contains(Cell cell) const {
    return cell.column >= 0 && cell.row >= 0 && cell.column < width_ && cell.row < height_;
  }
  std::int8_t valueAt(Cell cell) const {  // outside: 0
    return contains(cell) ? (*cells_)[indexOf(cell)] : std::int8_t{0};
  }
  bool isWall(Cell cell) const { return valueAt(cell) > 50; }
  bool isUnknown(Cell cell) const { return valueAt(cell) < 0; }

  std::size_t indexOf(Cell cell) const {  // index in cells(); the cell must lie inside
    assert(contains(cell));
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.column);
  }

  Cell worldToCell(const Vec2& point) const;    // floor; may lie outside; NaN: (-1, -1)
  Vec2 worldToCorner(const Vec2& point) const;  // without floor; inverse of cornerToWorld
  Vec2 cellToWorld(Cell cell) const {           // centre
    return cornerToWorld(cell.column + 0.5, cell.row + 0.5);
  }
  Vec2 cornerToWorld(double column, double row) const;  // cell coordinates -> world

  friend bool operator==(const OccupancyGrid& a, const OccupancyGrid& b);

 private:
  int width_ = 0;
  int height_ = 0;
  double resolution_ = 0.05;  // [m]
  Pose2 origin_;
  Vec2 axis_{1.0, 0.0};                                    // direction of growing columns
  std::shared_ptr<const std::vector<std::int8_t>> cells_;  // null: none
};

}  // namespace sim2d
