#pragma once

#include <memory>
#include <vector>

#include "sim2d/base/StopFlag.h"
#include "sim2d/map/BorderCells.h"
#include "sim2d/map/CellDistances.h"
#include "sim2d/map/Obstacles.h"

namespace sim2d {

/// Clearance of every cell of a regular grid: the cells of the map, or without a map 0.1 m cells
/// (coarser above 4 million) over the bounds of the obstacles plus a margin. Value: Euclidean
/// distance [m] from the cell centre to the nearest wall; exact for map cells and within 1.2 m of
/// enabled obstacles, otherwise accurate to one cell; 0 inside walls, infinite if there is no wall.
/// Immutable and thread-safe. Large maps use two bytes per cell: rounded down to 1/256 cell, at
/// most 255 cells.
class DistanceField {
 public:
  /// `bounds`: points that the grid must contain if there is no map (starts, goals …). `obstacles`
  /// must be built; its parts may include the map's outlines; disabled parts count as free. Maps of
  /// more than `mostCells` cells are large. `walls`: result of `mapWallDistances`; null: it is
  /// computed.
  DistanceField(const OccupancyGrid& grid, const Obstacles& obstacles,
                const std::vector<Vec2>& bounds = {}, double mostCells = kMaxCells,
                base::StopFlagPtr stop = std::make_shared<const base::StopFlag>(),
                const std::shared_ptr<const CellDistances>& walls = nullptr);
  /// A field with exact distances for maps of any size. Above `mostKept` cells they are computed on
  /// demand, so `obstacles` must outlive the field and stay unchanged.
  static std::shared_ptr<const DistanceField> withExactDistances(const OccupancyGrid& grid,
                                                                 const Obstacles& obstacles,
                                                                 const std::vector<Vec2>& bounds,
                                                                 double mostKept = kMaxCells);
  /// The distances to the walls of the map alone, which several fields can share.
  static std::shared_ptr<const CellDistances> mapWallDistances(const OccupancyGrid& grid,
                                                               bool isLarge,
                                                               const base::StopFlag& stop);

  static constexpr double kMaxCells = 4e6;

  /// Walls include obstacles, except on large maps and for distances on demand: there it is the map
  /// itself, which shares its cells.
  const OccupancyGrid& grid() const { return grid_; }
  bool isLarge() const { return isLarge_; }
  bool isOpenPlane() const { return isOpenPlane_; }  // no map: free beyond the grid
  double distanceAt(Cell cell) const;                // outside: to the nearest wall in the grid
  double distanceAt(const Vec2& point) const;        // bilinear
  /// From a position outside the grid [cells, from its corner]; `examined`: see `BorderCells`.
  double outsideDistance(const Vec2& corner, std::size_t* examined = nullptr) const {
    return border_.distance(corner, examined) * grid_.resolution();
  }
  /// [cells] from the cell centre to the nearest unknown cell: 0 inside, infinite if all cells are
  /// known. On a large map a lower bound for any point of the cell.
  double unknownDistance(Cell cell) const;
  bool hasUnknown() const {
    return lazy_ != nullptr ? lazy_->unknown().isAny() : !toUnknown_.empty();
  }
  /// Unknown in the map and not covered by an obstacle (on large maps: unknown in the map).
  bool isUnknown(Cell cell) const {
    return grid_.isUnknown(cell) && (lazy_ == nullptr || !lazy_->isCovered(cell));
  }
  /// Distances are computed on demand, which takes a microsecond or more; neighbours differ by at
  /// most one cell, except where the exact range begins.
  bool isLazyAndSmooth() const { return lazy_ != nullptr && lazy_->isSmooth(); }
  /// Also stops the computation of everything derived from this field.
  const base::StopFlag& stopFlag() const { return *stop_; }
  /// Memory [bytes] without the cells of the map.
  std::size_t bytes() const;

 private:
  struct LazyTag {};
  DistanceField(const OccupancyGrid& grid, const Obstacles& obstacles, LazyTag);
  void keepDistances(const Obstacles& obstacles, const std::vector<char>& covered);
  float valueAt(std::size_t index) const {
    return lazy_ == nullptr ? distance_.at(index) : lazy_->at(index);
  }
  bool isSolid(Cell cell) const;
  void findBorder();
  void measureUnknown();

  base::StopFlagPtr stop_;
  OccupancyGrid grid_;
  bool isOpenPlane_ = false;
  bool isLarge_ = false;
  CellDistances distance_;  // [m]; empty if lazy_ is set
  std::unique_ptr<const LazyDistances> lazy_;
  std::vector<float> toUnknown_;  // [cells] per cell; on a large map [blocks] per block
  BorderCells border_;            // wall cells that can be the nearest ones from outside the grid
};

/// Marks the cells of `grid` (row-major, 1 = marked) that enabled obstacles cover: cells whose
/// centre is solid, and cells that an outline crosses unless they are next to a wall of the map (so
/// that the map's own outlines do not thicken its walls). `isLarge`: ignores the outlines of the
/// map.
std::vector<char> cellsOfObstacles(const OccupancyGrid& grid, const Obstacles& obstacles,
                                   bool isLarge, const base::StopFlag& stop = {});

/// Marks the wall cells of the map.
std::vector<char> cellsOfWalls(const OccupancyGrid& grid);

}  // namespace sim2d
