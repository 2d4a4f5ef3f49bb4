#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim2d/base/StopFlag.h"
#include "sim2d/map/Obstacles.h"
#include "sim2d/map/OccupancyGrid.h"

namespace sim2d {

/// Exact Euclidean distance transform: distance [cells] from the centre of each cell of a row-major
/// grid to the nearest square of a marked cell; 0 in marked cells, 0.5 in adjacent ones, infinity
/// if no cell is marked. Linear time (Felzenszwalb and Huttenlocher 2012, lower envelope of
/// parabolas, here placed on cell borders).
std::vector<float> distancesToMarked(int width, int height, const std::vector<char>& marked,
                                     const base::StopFlag& stop = {});

/// The same in two bytes per cell: units of 1/256 cell, rounded down; `kMaxSteps` for larger
/// distances and if no cell is marked.
std::vector<std::uint16_t> quantizedDistancesToMarked(int width, int height,
                                                      const std::vector<char>& marked,
                                                      const base::StopFlag& stop = {});
constexpr std::uint16_t kMaxSteps = 65535;
constexpr float kStepsPerCell = 256.0F;

/// Distances of all cells multiplied by the cell size, as floats or (`isQuantized`) quantized to 16
/// bits.
class CellDistances {
 public:
  CellDistances() = default;
  CellDistances(int width, int height, const std::vector<char>& marked, float cell,
                bool isQuantized, const base::StopFlag& stop);

  /// Infinity if no cell is marked.
  float at(std::size_t index) const {
    if (steps_.empty()) {
      return exact_[index];
    }
    return steps_[index] == kMaxSteps ? saturatedValue_ : static_cast<float>(steps_[index]) * step_;
  }
  void set(std::size_t index, float distance);
  /// Replaces infinite values by `distance`, unless all are infinite.
  void replaceInfinite(float distance);
  std::size_t bytes() const { return sizeof(float) * exact_.size() + 2 * steps_.size(); }

 private:
  std::vector<float> exact_;
  std::vector<std::uint16_t> steps_;
  float step_ = 0.0F;            // length of one quantization step
  float saturatedValue_ = 0.0F;  // value for `kMaxSteps`
};

/// Marked cells of a grid with nearest-neighbour queries, in about 1/8 byte per cell: a bitmap, and
/// above it levels in which each bit summarises a block of 8 x 8 bits. Immutable and thread-safe.
class MarkedCellIndex {
 public:
  /// `isMarked(Cell)` is called once per cell.
  template <class IsMarked>
  MarkedCellIndex(int width, int height, IsMarked isMarked, const base::StopFlag& stop)
      : MarkedCellIndex(width, height) {
    for (int row = 0; row < height; ++row) {
      stop.check();
      for (int column = 0; column < width; ++column) {
        if (isMarked(Cell{column, row})) {
          mark({column, row});
        }
      }
    }
    buildLevels();
  }

  bool isAny() const { return levels_.back().blocks[0] != 0; }
  bool isMarked(Cell cell) const {  // the cell must lie inside the grid
    return (blockOf(levels_[0], cell) & bitOf(cell)) != 0;
  }
  /// [cells], identical to `distancesToMarked`.
  float distance(Cell cell) const;
  std::size_t bytes() const;

 private:
  using Block = std::uint64_t;
  struct Level {
    int columns = 0;  // blocks per row
    std::vector<Block> blocks;
  };
  struct Search;

  MarkedCellIndex(int width, int height);
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
  void buildLevels();

  std::vector<Level> levels_;  // cells, blocks of cells, …
};

/// Within this distance of an obstacle [m] its exact distance is used; farther ones use the
/// distance to the cells it covers.
constexpr double kExactRange = 1.2;

/// Whether an enabled part extends beyond the map.
bool extendBeyondGrid(const OccupancyGrid& grid, const Obstacles& obstacles);

/// Combines distances to the walls of a map with those to obstacles. Both arguments must outlive
/// it.
class ObstacleClearance {
 public:
  ObstacleClearance(const OccupancyGrid& grid, const Obstacles& obstacles);

  /// `distance`: [m] from the cell to the walls; `toCovered`: [cells] to cells that obstacles
  /// cover.
  float lowered(Cell cell, float distance, float toCovered) const;
  /// An obstacle beyond the grid affects the cells near the grid's edge.
  bool affectsGridEdge() const { return edge_ > 0; }

 private:
  const OccupancyGrid& grid_;
  const Obstacles& obstacles_;
  float size_;    // [m], cell size
  double limit_;  // [m]
  int edge_;      // [cells], width of the border affected by obstacles beyond the grid
};

/// Clearances of map cells computed on demand: the same values as those of a `DistanceField` of an
/// ordinary map, in less than half a byte per cell instead of nine. `obstacles` must outlive it and
/// stay unchanged. Thread-safe.
class LazyDistances {
 public:
  /// `covered`: the cells that obstacles cover. There must be a covered cell or a wall.
  LazyDistances(const OccupancyGrid& grid, const Obstacles& obstacles,
                const std::vector<char>& covered, const base::StopFlag& stop);
  LazyDistances(const LazyDistances&) = delete;
  LazyDistances& operator=(const LazyDistances&) = delete;
  LazyDistances(LazyDistances&&) = delete;
  LazyDistances& operator=(LazyDistances&&) = delete;
  ~LazyDistances() = default;

  float at(std::size_t index) const;  // [m]
  bool isSmooth() const { return !pass_.affectsGridEdge(); }
  bool isCovered(Cell cell) const { return covered_.isMarked(cell); }
  /// The unknown cells that no obstacle covers.
  const MarkedCellIndex& unknown() const { return unknown_; }
  std::size_t bytes() const { return walls_.bytes() + covered_.bytes() + unknown_.bytes(); }

 private:
  OccupancyGrid grid_;
  MarkedCellIndex walls_, covered_, unknown_;
  ObstacleClearance pass_;
  bool isLowered_;
};

}  // namespace sim2d
