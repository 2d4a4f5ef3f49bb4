#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"

/// Distances from seed cells over a costmap (dwb_critics/map_grid.cpp, costmap_queue).
namespace sim2d::nav2 {

/// The value of a cell is |dx| + |dy| to the seed that reached it first. Cells are processed in
/// order of the Euclidean distance from their seed (of equal distances, the cell found last
/// first) and propagate the seed to the left, lower, right and upper neighbour. Ignores obstacles.
/// Expands only as far as requested.
class MapGrid {
 public:
  /// Removes all seeds and sets the size.
  void clear(int width, int height);
  void seed(Cell cell) { seeds_.push_back(cell); }
  bool hasSeeds() const { return !seeds_.empty(); }

  /// Distance in cells from a cell index to its seed; without seeds the number of cells + 1.
  double at(int index) {
    if (seeds_.size() == 1) {  // it reaches all cells
      const Cell seed = seeds_.front();
      return std::abs(index % width_ - seed.column) + std::abs(index / width_ - seed.row);
    }
    if (!isStarted_) {
      start();
    }
    const auto cell = static_cast<std::size_t>(index);
    if (values_[cell] == kUnvisited) {
      propagateTo(cell);
    }
    return values_[cell] == kUnvisited ? unreachable() : values_[cell];
  }
  double unreachable() const { return static_cast<double>(width_) * height_ + 1.0; }

 private:
  struct Entry {          // a queued cell
    std::int32_t next;    // next cell of its bucket; -1: none
    std::int16_t dx, dy;  // offset from its seed
  };
  static constexpr std::int32_t kUnvisited = -1;

  void start();
  void propagateTo(std::size_t cell);
  void push(std::int32_t cell, int dx, int dy);
  std::int32_t pop();

  int width_ = 0, height_ = 0;
  std::vector<Cell> seeds_;
  bool isStarted_ = false;            // what follows is filled
  std::vector<std::int32_t> values_;  // kUnvisited until processed
  std::vector<std::uint8_t> isFound_;
  std::vector<Entry> entries_;
  std::vector<std::int32_t> buckets_;  // buckets by squared distance: first cell, -1: none
  std::size_t nearest_ = 0;            // lower buckets are empty
  std::size_t farthest_ = 0;           // higher buckets are empty
  std::size_t waiting_ = 0;            // queued cells
};

/// The path with poses inserted where consecutive poses are more than two cells apart
/// (nav_2d_utils::adjustPlanResolution). Inserted poses have the heading of the previous pose.
Path adjustPlanResolution(const Path& path, double resolution);

/// Seed cells of a path: its first section on known cells of the map.
std::vector<Cell> pathSeeds(const Path& path, const Costmap& costmap);

}  // namespace sim2d::nav2
