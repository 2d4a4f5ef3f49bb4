#pragma once

#include <memory>
#include <vector>

#include "sim2d/map/CellDistances.h"
#include "sim2d/map/ObstaclePass.h"
#include "sim2d/map/Obstacles.h"

namespace sim2d {

/// Clearance of every cell of a regular grid over the world: the map's own cells, or 0.1 m cells
/// (coarser beyond 4 million) over the obstacles' bounds plus a margin when there is no map.
/// Euclidean distance from the cell centre to the nearest wall [m]: exact for the cells of the map
/// and within 1.2 m of enabled obstacles, farther ones to one cell; 0 inside walls, infinite when
/// there is no wall. Immutable; safe to share between threads.
/// Large maps are kept in two bytes per cell: rounded down to 1/256 cell, 255 cells at most.
class DistanceField {
 public:
  /// `bounds` are points that must lie inside when the map is the open plane (starts, goals …).
  /// `obstacles` are built; parts may repeat the outlines of the map. Parts switched off are free.
  /// Maps of more than `mostCells` are large. `walls`: as of `wallsOf`, null: they are worked out.
  DistanceField(const OccupancyGrid& grid, const Obstacles& obstacles,
                const std::vector<Vec2>& bounds = {}, double mostCells = kMostCells,
                base::StopFlagPtr stop = std::make_shared<const base::StopFlag>(),
                const std::shared_ptr<const CellDistances>& walls = nullptr);
  /// As of an ordinary map, whatever its size; for one of more cells than `mostKept` distances are
  /// worked out when they are asked for, so that `obstacles` must live and stay as long as this.
  static std::shared_ptr<const DistanceField> ofExactCells(const OccupancyGrid& grid,
                                                           const Obstacles& obstacles,
                                                           const std::vector<Vec2>& bounds,
                                                           double mostKept = kMostCells);
  /// The share of the walls of a map in its fields, whatever else stands there.
  static std::shared_ptr<const CellDistances> wallsOf(const OccupancyGrid& grid, bool isLarge,
                                                      const base::StopFlag& stop);

  static constexpr double kMostCells = 4e6;

  /// Wall = map wall or obstacle; where distances are few or none the map itself, whose cells are
  /// shared.
  const OccupancyGrid& grid() const { return grid_; }
  bool isLarge() const { return isLarge_; }
  bool isOpenPlane() const { return isOpenPlane_; }  // there was no map: free beyond the grid
  double distanceAt(Cell cell) const;          // outside the grid: to the nearest wall of the grid
  double distanceAt(const Vec2& point) const;  // bilinear
  /// [cells] from the centre to the nearest unknown cell: 0 inside, infinite when all is known. Of
  /// a large map, from any point of the cell and at least so much.
  double unknownDistance(Cell cell) const;
  bool hasUnknown() const {
    return asked_ != nullptr ? asked_->unknown().isAny() : !toUnknown_.empty();
  }
  /// No obstacle covers it either, unless the map is large.
  bool isUnknown(Cell cell) const {
    return grid_.isUnknown(cell) && (asked_ == nullptr || !asked_->isCovered(cell));
  }
  /// Distances are worked out when they are asked for, which takes a microsecond or more, and those
  /// of neighbours differ by a cell at most, but for the places where they begin to be exact.
  bool isAskedAndSmooth() const { return asked_ != nullptr && asked_->isSmooth(); }
  /// For all that is worked out from it, as for itself.
  const base::StopFlag& stopFlag() const { return *stop_; }
  /// Memory taken, but for the cells of the map.
  std::size_t bytes() const;

 private:
  struct Asked {};
  DistanceField(const OccupancyGrid& grid, const Obstacles& obstacles, Asked);
  void keepDistances(const Obstacles& obstacles, const std::vector<char>& covered);
  float valueAt(std::size_t index) const {
    return asked_ == nullptr ? distance_.at(index) : asked_->at(index);
  }
  bool isSolid(Cell cell) const;
  void findBorder();
  void measureUnknown();
  double outsideDistance(const Vec2& corner) const;

  base::StopFlagPtr stop_;
  OccupancyGrid grid_;
  bool isOpenPlane_ = false;
  bool isLarge_ = false;
  CellDistances distance_;  // [m]; none when there is the next
  std::unique_ptr<const AskedDistances> asked_;
  std::vector<float> toUnknown_;  // [cells] by cell, [blocks] by block of a large map
  std::vector<Cell> border_;      // wall cells beside free ones, for places outside the grid
};

}  // namespace sim2d
