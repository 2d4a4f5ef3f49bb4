#pragma once

#include <atomic>
#include <memory>
#include <mutex>
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

/// Length of a path [m]; 0 if empty.
double polylineLength(const std::vector<Vec2>& path);
/// Length [m] from a position to point `first` of a path and on to its end.
double polylineLength(const Vec2& from, const std::vector<Vec2>& path, std::size_t first);

/// Path planning around walls for bodies of one radius; one planner serves all bodies of that
/// radius. Searches are cached per goal cell, so many people with one goal cost one search. Cells
/// with less clearance than the radius are closed; up to 0.3 m more clearance is preferred; unknown
/// cells are entered only if there is no other path. Paths are shortened to straight legs that keep
/// the clearance, to a centimetre. Outside a map everything is closed; outside the grid of an open
/// plane everything is open. On a large map (`DistanceField::isLarge`) the search uses blocks of
/// cells: paths exist under the same conditions and keep their clearance, but may be up to about 8
/// % longer than optimal. `PathObjective::Length` gives the shortest path, to 3.1 % and about a
/// cell per corner, cell by cell on maps of any size; it should be tightened afterwards. Results
/// depend only on the arguments. Thread-safe; queries throw `base::Stopped` if the field's flag is
/// set.
class PathPlanner {
 public:
  PathPlanner(std::shared_ptr<const DistanceField> field, double radius,
              PathObjective objective = PathObjective::Clearance);

  /// Straight legs including start and goal; empty: there is no path. A start or goal in a closed
  /// cell is first moved to the nearest open cell within 1 m: the path ends at the moved goal, and
  /// the original start is followed by the moved one (or omitted if a wall lies between). Equal
  /// start and goal: two equal points.
  std::vector<Vec2> plan(const Vec2& start, const Vec2& goal);
  /// The same, also avoiding the convex polygons `closed`, which must not contain the start or the
  /// goal. The search is not cached, because such obstacles are temporary. Searches the cells
  /// within `kDetourRange` of start and goal; empty as well if these are more than 4 million.
  std::vector<Vec2> planAround(const Vec2& start, const Vec2& goal,
                               const std::vector<std::vector<Vec2>>& closed);
  static constexpr double kDetourRange = 25.0;  // [m]
  bool isReachable(const Vec2& start, const Vec2& goal);
  /// Whether the straight line keeps the clearance.
  bool isClear(const Vec2& from, const Vec2& to) const {
    return space_.lineHasClearance(from, to, space_.bodyRadius(), true);
  }
  const TraversableSpace& space() const { return space_; }

  /// Number of goals searched so far, including removed ones.
  int searches() const;
  /// Memory [bytes] without the field. Does not block.
  std::size_t bytes() const { return bytes_; }

 private:
  CellPathFinder& finder();
  const Terrain* knownTerrain();
  std::vector<Cell> cellPath(Cell from, Cell to);
  std::vector<Vec2> planThroughCells(const TraversableSpace::Anchor& from,
                                     const TraversableSpace::Anchor& to);

  TraversableSpace space_;
  PathObjective objective_;
  mutable std::mutex mutex_;  // guards the members below
  std::unique_ptr<CellPathFinder> finder_;
  std::atomic<std::size_t> bytes_{0};
};

}  // namespace sim2d
