#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim2d/base/Stop.h"
#include "sim2d/map/OccupancyGrid.h"

namespace sim2d {

/// Which cells of a grid are marked and how far the nearest of them is, in about 1/8 byte per cell:
/// a bit for each cell, and for each block of 8 x 8 bits one that tells whether any is set, up to
/// one block for all. Immutable; thread: any.
class NearestMark {
 public:
  /// `isMarked(Cell)` is asked once for each cell.
  template <class IsMarked>
  NearestMark(int width, int height, IsMarked isMarked, const base::StopFlag& stop)
      : NearestMark(width, height) {
    for (int row = 0; row < height; ++row) {
      stop.check();
      for (int column = 0; column < width; ++column) {
        if (isMarked(Cell{column, row})) {
          mark({column, row});
        }
      }
    }
    summarise();
  }

  bool isAny() const { return levels_.back().blocks[0] != 0; }
  bool isMarked(Cell cell) const {  // it must lie inside
    return (blockOf(levels_[0], cell) & bitOf(cell)) != 0;
  }
  /// [cells], as `distancesToMarked` has it, to the last bit.
  float distance(Cell cell) const;
  std::size_t bytes() const;

 private:
  using Block = std::uint64_t;
  struct Level {
    int columns = 0;  // of blocks
    std::vector<Block> blocks;
  };
  struct Search;

  NearestMark(int width, int height);
  static Block bitOf(Cell cell) {
    return Block{1} << (8U * (static_cast<unsigned>(cell.row) % 8U) +
                        static_cast<unsigned>(cell.column) % 8U);
  }
  static std::size_t indexOf(const Level& level, Cell cell) {
    return static_cast<std::size_t>(cell.row / 8) * static_cast<std::size_t>(level.columns) +
           static_cast<std::size_t>(cell.column / 8);
  }
  static Block blockOf(const Level& level, Cell cell) { return level.blocks[indexOf(level, cell)]; }
  void mark(Cell cell) { levels_[0].blocks[indexOf(levels_[0], cell)] |= bitOf(cell); }
  void summarise();

  std::vector<Level> levels_;  // of cells, of blocks of them …
};

}  // namespace sim2d
