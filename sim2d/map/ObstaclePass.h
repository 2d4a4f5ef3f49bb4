#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/map/NearestMark.h"
#include "sim2d/map/Obstacles.h"

namespace sim2d {

/// How far around obstacles their own distance counts [m]; farther away that to the cells that they
/// cover.
constexpr double kExactRange = 1.2;

/// Some enabled part is not all on the map.
bool reachBeyond(const OccupancyGrid& grid, const Obstacles& obstacles);

/// Lowers distances to the walls of a map to those to walls and obstacles. Both arguments must live
/// as long.
class ObstaclePass {
 public:
  ObstaclePass(const OccupancyGrid& grid, const Obstacles& obstacles);

  /// `distance` [m] of the cell to the walls, `toCovered` [cells] to cells that obstacles cover.
  float lowered(Cell cell, float distance, float toCovered) const;
  /// Something stands beyond the grid: it lowers what is near the edge, and nothing farther in.
  bool reachesIn() const { return edge_ > 0; }

 private:
  const OccupancyGrid& grid_;
  const Obstacles& obstacles_;
  float size_;    // [m] of a cell
  double limit_;  // [m]
  int edge_;      // [cells] from the edge of the grid on which acts what stands beyond it
};

/// Clearances of the cells of a map, worked out when they are asked for: as an ordinary
/// `DistanceField` has them, to the last bit, in less than half a byte per cell instead of nine.
/// `obstacles` must live and stay as long. Thread: any.
class AskedDistances {
 public:
  /// `covered`: the cells of the obstacles. There must be one, or a wall.
  AskedDistances(const OccupancyGrid& grid, const Obstacles& obstacles,
                 const std::vector<char>& covered, const base::StopFlag& stop);
  AskedDistances(const AskedDistances&) = delete;
  AskedDistances& operator=(const AskedDistances&) = delete;
  AskedDistances(AskedDistances&&) = delete;
  AskedDistances& operator=(AskedDistances&&) = delete;
  ~AskedDistances() = default;

  float at(std::size_t index) const;  // [m]
  bool isSmooth() const { return !pass_.reachesIn(); }
  bool isCovered(Cell cell) const { return covered_.isMarked(cell); }
  /// To the unknown cells that nothing covers.
  const NearestMark& unknown() const { return unknown_; }
  std::size_t bytes() const { return walls_.bytes() + covered_.bytes() + unknown_.bytes(); }

 private:
  OccupancyGrid grid_;
  NearestMark walls_, covered_, unknown_;
  ObstaclePass pass_;
  bool isLowered_;
};

}  // namespace sim2d
