#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sim2d/map/DistanceField.h"

namespace sim2d {

/// A path of straight legs, start and goal included; empty = there is none. A goal that had to be
/// moved ends it where it was moved to; a start that had to be moved is followed by its new place
/// (and left out if a wall lies between). Start and goal alike: two equal points.
struct Path {
  std::vector<Vec2> points;
  double length() const;
};

/// Ways round walls for bodies of one radius. One planner per (obstacles, radius class), shared by
/// all bodies of that radius; distance-to-goal fields are kept per goal cell (bounded cache), so
/// many people with one goal cost one search. Cells with less clearance than the radius are closed;
/// wider clearance is preferred up to 0.3 m more; unknown cells are entered only where there is no
/// other way. Paths are pulled straight where the line keeps the clearance, which holds to a
/// centimetre. Beyond a map nothing is open; beyond the grid of an open plane all is. The result
/// depends on the arguments alone, not on earlier calls. Thread: any.
class PathPlanner {
 public:
  PathPlanner(std::shared_ptr<const DistanceField> field, double radius);

  /// A start or goal in a closed cell is moved to the nearest open one within 1 m first.
  Path plan(const Vec2& start, const Vec2& goal);
  bool isReachable(const Vec2& start, const Vec2& goal);
  /// The straight line keeps the clearance all along.
  bool isClear(const Vec2& from, const Vec2& to) const;
  /// `point` if a body of this radius fits, else the nearest place within 1 m where it does.
  std::optional<Vec2> nearestFit(const Vec2& point) const;
  double radius() const;

 private:
  struct Search;
  std::shared_ptr<Search> search_;  // copies share it
};

}  // namespace sim2d
