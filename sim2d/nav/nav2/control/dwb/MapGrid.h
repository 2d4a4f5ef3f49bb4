#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"

/// Distances from seeds over a costmap (dwb_critics/map_grid.cpp, costmap_queue).
namespace sim2d::nav2 {

/// The value of a cell is |dx| + |dy| to the seed that reached it first, where cells are taken in
/// order of their straight distance from their seed, of equal ones the last found, and hand their
/// seed on to left, below, right, above. Obstacles are no hindrance. Grows as far as it is asked.
class MapGrid {
 public:
  /// No seeds; on a map of that size.
  void clear(int width, int height);
  void seed(Cell cell);
  bool hasSeeds() const { return hasSeeds_; }

  /// Cells to the seed of a cell by its index; without seeds the number of cells + 1.
  double at(int index) {
    const auto cell = static_cast<std::size_t>(index);
    if (values_[cell] == kNotYet) {
      growTo(cell);
    }
    return values_[cell] == kNotYet ? unreachable() : values_[cell];
  }
  double unreachable() const { return static_cast<double>(values_.size()) + 1.0; }

 private:
  struct Entry {          // of a cell that waits
    std::int32_t next;    // below it in its pile; -1: none
    std::int16_t dx, dy;  // from its seed
  };
  static constexpr std::int32_t kNotYet = -1;

  void growTo(std::size_t cell);
  void push(std::int32_t cell, int dx, int dy);
  std::int32_t pop();

  int width_ = 0, height_ = 0;
  bool hasSeeds_ = false;
  std::vector<std::int32_t> values_;  // kNotYet until taken
  std::vector<std::uint8_t> isFound_;
  std::vector<Entry> entries_;
  std::vector<std::int32_t> piles_;  // by squared distance: the topmost cell, -1: none
  std::size_t nearest_ = 0;          // no pile below has a cell
  std::size_t farthest_ = 0;         // nor one above this
  std::size_t waiting_ = 0;          // cells on piles
};

/// The path with places in between where its poses lie more than two cells apart
/// (nav_2d_utils::adjustPlanResolution). Headings are those of the pose before.
Path refined(const Path& path, double resolution);

/// Seeds of a path: its first stretch on the map and known.
std::vector<Cell> pathSeeds(const Path& path, const Costmap& costmap);

}  // namespace sim2d::nav2
