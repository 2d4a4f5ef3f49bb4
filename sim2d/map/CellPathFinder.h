#pragma once

#include <memory>
#include <vector>

#include "sim2d/map/TraversableSpace.h"

namespace sim2d {

/// What a path minimises: a cost that prefers clearance, or its length.
enum class PathObjective { Clearance, Length };

/// Path search over the open cells of a walk space. Not thread-safe.
class CellPathFinder {
 public:
  virtual ~CellPathFinder() = default;
  virtual bool isReachable(Cell from, Cell to) = 0;
  /// Cells from start to goal, consecutive ones connected by straight lines; empty: no path.
  virtual std::vector<Cell> path(Cell from, Cell to) = 0;
  /// Number of goals searched so far, including removed ones.
  virtual int searches() const = 0;
  virtual std::size_t bytes() const = 0;
  /// The cells with their costs by clearance if this finder searches them, else null. Valid as long
  /// as the finder.
  virtual const Terrain* clearanceTerrain() const { return nullptr; }
};

/// Searches cells, or blocks of cells on a large map unless the length is minimised. `space` must
/// outlive the finder.
std::unique_ptr<CellPathFinder> makeCellPathFinder(const TraversableSpace& space,
                                                   PathObjective objective);

}  // namespace sim2d
