#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sim2d/map/DistanceField.h"

namespace sim2d {

constexpr double kPreferredClearance = 0.3;  // [m], preferred in addition to the radius

/// Cost of a cell for a body of this radius: 6 with the preferred clearance, up to 12 where it just
/// fits, 0 where it does not fit.
std::uint8_t cellCostOf(const DistanceField& field, double radius, Cell cell);

/// Traversable cells for a body of one radius: the cells of a distance field, or of a rectangle of
/// it, with their costs, surrounded by one closed cell on each side.
class Terrain {
 public:
  using Index = std::int32_t;

  Terrain(const DistanceField& field, double radius);
  /// The cells from `low` to `high`, both included; they must lie in the field.
  Terrain(const DistanceField& field, double radius, Cell low, Cell high);

  bool isOpen(Index index) const { return cellCosts_[static_cast<std::size_t>(index)] != 0; }
  bool isUnknown(Index index) const {
    return (cellCosts_[static_cast<std::size_t>(index)] & kUnknown) != 0;
  }
  std::uint32_t cellCost(Index index) const {
    return cellCosts_[static_cast<std::size_t>(index)] & ~kUnknown;
  }
  Index indexOf(Cell cell) const {
    return (cell.row - low_.row + 1) * stride_ + cell.column - low_.column + 1;
  }
  Cell cellOf(Index index) const {
    return {index % stride_ - 1 + low_.column, index / stride_ - 1 + low_.row};
  }
  Index stride() const { return stride_; }
  std::size_t size() const { return cellCosts_.size(); }
  const base::StopFlag& stopFlag() const { return *stop_; }

  /// Calls visit(Index, std::uint32_t cost) for each open neighbour, at most eight.
  template <class Visit>
  void forEachStep(Index from, Visit visit) const {
    for (const Neighbour& neighbour : neighbours_) {
      if (canStep(from, neighbour)) {
        visit(from + neighbour.offset, stepCost(from, neighbour));
      }
    }
  }

 protected:
  struct Neighbour {
    Index offset = 0;
    std::uint32_t length = 0;
    Index first = 0, second = 0;  // cells passed by a diagonal step; 0 for straight ones
  };
  Terrain(const DistanceField& field, Cell low, Cell high);  // all cells closed
  std::uint32_t stepCost(Index from, const Neighbour& neighbour) const;
  void setCellCost(Index index, std::uint8_t cellCost, bool isUnknown) {
    cellCosts_[static_cast<std::size_t>(index)] =
        static_cast<std::uint8_t>(isUnknown ? cellCost | kUnknown : cellCost);
  }

 private:
  static constexpr std::uint32_t kUnknown = 0x80;  // flag in the cost byte

  bool canStep(Index from, const Neighbour& neighbour) const {
    return isOpen(from + neighbour.offset) && isOpen(from + neighbour.first) &&
           isOpen(from + neighbour.second);
  }

  const base::StopFlag* stop_;  // of the field
  Cell low_;
  Index stride_;
  std::array<Neighbour, 8> neighbours_;
  std::vector<std::uint8_t> cellCosts_;  // 0: closed
};

/// Step cost: 12 times the length in cells, times the sum of the costs of both ends.
constexpr std::uint32_t kCellLength = 12;
constexpr std::uint32_t kUnknownFactor = 16;

inline std::uint32_t Terrain::stepCost(Index from, const Neighbour& neighbour) const {
  const Index to = from + neighbour.offset;
  const std::uint32_t cost = neighbour.length * (cellCost(from) + cellCost(to));
  return isUnknown(from) || isUnknown(to) ? kUnknownFactor * cost : cost;
}

/// Terrain for shortest paths: all cell costs are equal and steps go in 16 directions, so a path is
/// at most 3.1 % longer than the straight lines it approximates.
class UniformTerrain : public Terrain {
 public:
  UniformTerrain(const DistanceField& field, double radius);

  /// See Terrain.
  template <class Visit>
  void forEachStep(Index from, Visit visit) const {
    Terrain::forEachStep(from, visit);
    for (const Neighbour& knightMove : knightMoves_) {
      // Passed cells are checked first: leaving the terrain would pass its border.
      if (isOpen(from + knightMove.first) && isOpen(from + knightMove.second) &&
          isOpen(from + knightMove.offset)) {
        visit(from + knightMove.offset, stepCost(from, knightMove));
      }
    }
  }

 private:
  std::array<Neighbour, 8> knightMoves_;  // two cells along, one across
};

/// Free space of a body of one radius: valid positions and straight motions. Immutable.
class TraversableSpace {
 public:
  /// Start cell of a search from or to a point.
  struct Anchor {
    Vec2 place = Vec2::Zero();  // the point, or where it was moved to
    Cell cell;                  // open, near `place`
  };

  TraversableSpace(std::shared_ptr<const DistanceField> field, double radius);

  const DistanceField& field() const { return *field_; }
  const OccupancyGrid& grid() const { return field_->grid(); }
  double radius() const { return radius_; }
  /// The radius, but at least what prevents lines from passing through walls of one cell [m].
  double bodyRadius() const { return bodyRadius_; }

  bool isOpen(Cell cell) const {
    return grid().contains(cell) && cellCostOf(*field_, radius_, cell) != 0;
  }
  bool isUnknown(const Vec2& point) const { return field_->isUnknown(grid().worldToCell(point)); }
  bool fits(const Vec2& point) const;
  /// Whether the whole line keeps `clearance` [m], to a millimetre, and stays in the world. Unless
  /// `mayEnterUnknown`, it must also avoid unknown cells.
  bool lineHasClearance(const Vec2& from, const Vec2& to, double clearance,
                        bool mayEnterUnknown) const;
  /// Whether the line crosses no wall except one that contains or touches `from`.
  bool canExitTo(const Vec2& from, const Vec2& to) const;
  /// The point if the body fits, else a position within 1 m that can be reached without crossing a
  /// wall, else any within 1 m.
  std::optional<Vec2> nearestFreePosition(const Vec2& point) const;
  /// Outside the grid of an open plane everything is free: the search starts at the nearest cell of
  /// the grid.
  std::optional<Anchor> anchorOf(const Vec2& point) const;

 private:
  bool isInWorld(const Vec2& point) const {
    return field_->isOpenPlane() ? point.allFinite() : grid().contains(grid().worldToCell(point));
  }
  double unknownDistance(const Vec2& point) const;
  template <class Accept>
  std::optional<Cell> nearestOpenCell(const Vec2& point, Accept accept) const;

  std::shared_ptr<const DistanceField> field_;
  double radius_;
  double bodyRadius_;
  bool hasUnknown_;  // among the open cells
};

}  // namespace sim2d
