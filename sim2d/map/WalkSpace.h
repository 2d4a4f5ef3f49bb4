#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sim2d/map/Terrain.h"

namespace sim2d {

/// Where a body of one radius can be and which straight lines it can walk. Immutable.
class WalkSpace {
 public:
  /// Where a search from or to a point begins.
  struct Anchor {
    Vec2 place = Vec2::Zero();  // the point, or where it had to be moved
    Cell cell;                  // open, near the place
  };

  WalkSpace(std::shared_ptr<const DistanceField> field, double radius);

  const DistanceField& field() const { return *field_; }
  const OccupancyGrid& grid() const { return field_->grid(); }
  double radius() const { return radius_; }
  /// The radius, but no less than what keeps lines from slipping through walls of one cell [m].
  double bodyRadius() const { return bodyRadius_; }

  bool isOpen(Cell cell) const {
    return grid().contains(cell) && priceOf(*field_, radius_, cell) != 0;
  }
  bool isUnknown(const Vec2& point) const { return field_->isUnknown(grid().worldToCell(point)); }
  bool fits(const Vec2& point) const;
  /// All of the line keeps `clearance` [m], to a millimetre, and stays in the world; unless the
  /// last is set, also off unknown cells.
  bool lineKeeps(const Vec2& from, const Vec2& to, double clearance, bool mayEnterUnknown) const;
  /// The line crosses no wall except one that `from` stands in or touches.
  bool leadsOut(const Vec2& from, const Vec2& to) const;
  /// The point if the body fits, else a place within 1 m that it can be moved to without crossing
  /// a wall, else any within 1 m.
  std::optional<Vec2> nearestFit(const Vec2& point) const;
  /// Beyond the grid of an open plane all is free, so a way enters it at the nearest cell.
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
