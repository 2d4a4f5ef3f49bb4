#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "sim2d/map/WayFinder.h"

namespace sim2d {

/// Of all legs of a way [m]; 0 for none.
double lengthOfWay(const std::vector<Vec2>& way);
/// From a place to the point with number `first` of a way and on to its end [m].
double lengthOfWay(const Vec2& from, const std::vector<Vec2>& way, std::size_t first);

/// Ways round walls for bodies of one radius. One planner per (obstacles, radius class), shared by
/// all bodies of that radius; distance-to-goal fields are kept per goal cell (bounded cache), so
/// many people with one goal cost one search. Cells with less clearance than the radius are closed;
/// wider clearance is preferred up to 0.3 m more; unknown cells are entered only where there is no
/// other way. Paths are pulled straight where the line keeps the clearance, which holds to a
/// centimetre. Beyond a map nothing is open; beyond the grid of an open plane all is. On a large
/// map (`DistanceField::isLarge`) the way is chosen among blocks of cells, so that it may be longer
/// than the best one, by up to about 8 %; it exists where one does and keeps its clearance. With
/// `Prices::Length` the shortest is taken, to 3.1 % and about a cell at each corner, by cells on
/// maps of any size; to be pulled tight. The result depends on the arguments alone, not on earlier
/// calls. Thread: any; asking throws `base::Stopped` when the field's flag says so.
class PathPlanner {
 public:
  PathPlanner(std::shared_ptr<const DistanceField> field, double radius,
              Prices prices = Prices::Room);

  /// Straight legs, start and goal included; empty: there is no way. A start or goal in a closed
  /// cell is moved to the nearest open one within 1 m first. A goal that had to be moved ends the
  /// way where it was moved to; a start that had to be moved is followed by its new place (and left
  /// out if a wall lies between). Start and goal alike: two equal points.
  std::vector<Vec2> plan(const Vec2& start, const Vec2& goal);
  /// The same, and out of `closed` (convex polygons; none may hold the start or the goal): round
  /// what stands for a while, so nothing of the search is kept. By cells within `kAroundReach` of
  /// the two; empty as well where that are more than 4 million cells.
  std::vector<Vec2> planAround(const Vec2& start, const Vec2& goal,
                               const std::vector<std::vector<Vec2>>& closed);
  static constexpr double kAroundReach = 25.0;  // [m]
  bool isReachable(const Vec2& start, const Vec2& goal);
  /// The straight line keeps the clearance all along.
  bool isClear(const Vec2& from, const Vec2& to) const {
    return space_.lineKeeps(from, to, space_.bodyRadius(), true);
  }
  const WalkSpace& space() const { return space_; }

  /// Goals from which has been searched so far, those forgotten included.
  int searches() const;
  /// Memory taken, but for the field. Does not wait for who asks for a way.
  std::size_t bytes() const { return bytes_; }

 private:
  WayFinder& finder();
  const Terrain* knownTerrain();
  std::vector<Cell> cellsOfWay(Cell from, Cell to);
  std::vector<Vec2> planRound(const WalkSpace::Anchor& from, const WalkSpace::Anchor& to);

  WalkSpace space_;
  Prices prices_;
  mutable std::mutex mutex_;  // of what follows
  std::unique_ptr<WayFinder> finder_;
  std::atomic<std::size_t> bytes_{0};
};

}  // namespace sim2d
