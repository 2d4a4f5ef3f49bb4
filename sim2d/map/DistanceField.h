#pragma once

#include <vector>

#include "sim2d/map/Obstacles.h"

namespace sim2d {

/// Exact Euclidean distance, in cells, from the centre of each cell of a row-major grid to the
/// nearest square of a marked cell: 0 in marked cells, 0.5 beside them, infinity when none is
/// marked. Linear in the number of cells (Felzenszwalb and Huttenlocher 2012, lower envelope of
/// parabolas, here over the borders of cells).
std::vector<float> distancesToMarked(int width, int height, const std::vector<char>& marked);

/// Clearance of every cell of a regular grid over the world: the map's own cells, or 0.1 m cells
/// (coarser beyond 4 million) over the obstacles' bounds plus a margin when there is no map.
/// Euclidean distance from the cell centre to the nearest wall [m]: exact for the cells of the map
/// and within 1.2 m of enabled obstacles, farther ones to one cell; 0 inside walls, infinite when
/// there is no wall. Immutable; safe to share between threads.
class DistanceField {
 public:
  /// `bounds` are points that must lie inside when the map is the open plane (starts, goals …).
  /// `obstacles` are built; parts may repeat the outlines of the map. Parts switched off are free.
  DistanceField(const OccupancyGrid& grid, const Obstacles& obstacles,
                const std::vector<Vec2>& bounds = {});

  const OccupancyGrid& grid() const { return grid_; }  // wall = map wall or obstacle
  bool isOpenPlane() const { return isOpenPlane_; }    // there was no map: free beyond the grid
  double distanceAt(Cell cell) const;          // outside the grid: to the nearest wall of the grid
  double distanceAt(const Vec2& point) const;  // bilinear

 private:
  double outsideDistance(const Vec2& corner) const;

  OccupancyGrid grid_;
  bool isOpenPlane_ = false;
  std::vector<float> distance_;
  std::vector<Cell> border_;  // wall cells beside free ones, for places outside the grid
};

}  // namespace sim2d
