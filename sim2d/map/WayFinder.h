#pragma once

#include <memory>
#include <vector>

#include "sim2d/map/WalkSpace.h"

namespace sim2d {

/// By what a way is chosen: by how much room it has, as bodies like it, or by its length alone.
enum class Prices { Room, Length };

/// Ways over the open cells of a walk space. Thread: one at a time.
class WayFinder {
 public:
  virtual ~WayFinder() = default;
  virtual bool isReachable(Cell from, Cell to) = 0;
  /// Cells from start to goal, each within a straight walk of the one before; empty: no way.
  virtual std::vector<Cell> way(Cell from, Cell to) = 0;
  /// Goals from which has been searched so far, those forgotten included.
  virtual int searches() const = 0;
  virtual std::size_t bytes() const = 0;
  /// All cells with their prices by room, where it goes by these; else null. It stays.
  virtual const Terrain* roomTerrain() const { return nullptr; }
};

/// Over all cells, or over blocks of them where the map is large and not the length alone counts.
/// `space` lives longer.
std::unique_ptr<WayFinder> makeWayFinder(const WalkSpace& space, Prices prices);

}  // namespace sim2d
