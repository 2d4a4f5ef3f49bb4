#pragma once

#include <vector>

#include "sim2d/map/Obstacles.h"

namespace sim2d {

/// Clearance of every cell of a regular grid over the world: the map's own cells, or 0.1 m cells
/// over the obstacles' bounds plus a margin when there is no map. Euclidean distance from the cell
/// centre to the nearest wall [m], exact to one cell; 0 inside walls.
class DistanceField {
 public:
  /// `bounds` are points that must lie inside when the map is the open plane (starts, goals …).
  DistanceField(const OccupancyGrid& grid, const Obstacles& obstacles,
                const std::vector<Vec2>& bounds = {});

  const OccupancyGrid& grid() const { return grid_; }  // wall = map wall or obstacle
  double distanceAt(Cell cell) const;  // outside the grid: to the nearest wall, unbounded if none
  double distanceAt(const Vec2& point) const;  // bilinear
  Vec2 gradientAt(
      const Vec2& point) const;  // unit vector away from the nearest wall; zero where flat

 private:
  OccupancyGrid grid_;
  std::vector<float> distance_;
};

}  // namespace sim2d
