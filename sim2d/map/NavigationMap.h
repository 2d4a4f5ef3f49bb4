#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "sim2d/map/PathPlanner.h"

namespace sim2d {

/// Blocks of cells that contain no wall: a line of sight across such blocks needs no check against
/// walls. Immutable and thread-safe.
class OpenBlocks {
 public:
  explicit OpenBlocks(std::shared_ptr<const DistanceField> field);

  /// True: no wall in the grid-aligned rectangle with these corners. False: there may be one.
  bool areFree(const Vec2& from, const Vec2& to) const;

 private:
  int wallsBelow(int column, int row) const;

  std::shared_ptr<const DistanceField> field_;
  int width_ = 0, height_ = 0;  // [blocks]
  double perCell_ = 1.0;        // [blocks/cell]
  std::vector<int> below_;  // summed-area table of blocks with walls, (width + 1) x (height + 1)
};

/// Distance field and path planners of a map with obstacles, for one state of its doors; shared by
/// all planners of routes. Path planners are created per radius; the least recently used ones are
/// removed when all use more than `mostBytes`. Thread-safe.
class NavigationLayer {
 public:
  /// `places`: starts and goals; they bound the grid if there is no map.
  NavigationLayer(const OccupancyGrid& map, const Obstacles& obstacles,
                  const std::vector<Vec2>& places, base::StopFlagPtr stop,
                  const std::shared_ptr<const CellDistances>& walls,
                  std::size_t mostBytes = kMaxBytes);
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 30U;

  const DistanceField* field() const { return field_.get(); }  // null: there is no obstacle
  const OpenBlocks* blocks() const { return blocks_.get(); }   // also null then
  /// Requires an obstacle or a map.
  std::shared_ptr<PathPlanner> plannerFor(double radius) const;
  /// Memory [bytes] without the cells of the map.
  std::size_t bytes() const;

 private:
  struct Kept {
    std::shared_ptr<PathPlanner> planner;
    std::int64_t lastUse = 0;
  };
  std::size_t plannerBytes() const;

  std::shared_ptr<const DistanceField> field_;
  std::unique_ptr<const OpenBlocks> blocks_;
  const std::size_t mostBytes_;
  mutable std::mutex mutex_;
  mutable std::map<double, Kept> planners_;  // by radius [m]
  mutable std::int64_t uses_ = 0;
};

/// Cache of the layers of one map with its obstacles, by the state of the doors: the last ones
/// within `mostBytes`. Layers of maps that are not large share the distances to the map's walls.
/// Thread-safe.
class NavigationLayerCache {
 public:
  /// `stop` cancels the computation of layers (`base::Stopped`).
  explicit NavigationLayerCache(base::StopFlagPtr stop = std::make_shared<const base::StopFlag>(),
                                std::size_t mostBytes = NavigationLayer::kMaxBytes)
      : stop_(std::move(stop)), mostBytes_(mostBytes) {}
  std::shared_ptr<const NavigationLayer> of(const OccupancyGrid& map, const Obstacles& obstacles,
                                            const std::vector<Vec2>& places);
  const base::StopFlagPtr& stopFlag() const { return stop_; }

 private:
  struct Entry {
    std::vector<char> enabled;  // enabled state of each part
    std::vector<Vec2> places;   // used without a map only
    std::shared_ptr<const NavigationLayer> layer;
  };
  const base::StopFlagPtr stop_;
  const std::size_t mostBytes_;
  std::mutex mutex_;
  std::shared_ptr<const CellDistances> walls_;  // shared by all layers; null for a large map
  std::list<Entry> entries_;                    // most recently used first
};

/// Path planning around walls and obstacles for bodies of any radius, for the current state of the
/// doors. Not thread-safe.
class NavigationMap {
 public:
  /// `layers`: cache for this map and these obstacles; null: creates its own.
  NavigationMap(const OccupancyGrid& map, const Obstacles& obstacles, std::vector<Vec2> places,
                std::shared_ptr<NavigationLayerCache> layers = nullptr);
  /// To be called after doors were opened or closed.
  void update(const OccupancyGrid& map, const Obstacles& obstacles);
  /// Number of calls of `update`; older routes are outdated.
  int version() const { return version_; }

  /// From start to goal; empty if there is no path.
  std::vector<Vec2> plan(double radius, const Vec2& start, const Vec2& goal) const;
  /// The same, also avoiding convex polygons, which must not contain the start or the goal. Empty
  /// as well on the open plane, where no detour is needed.
  std::vector<Vec2> planAround(double radius, const Vec2& start, const Vec2& goal,
                               const std::vector<std::vector<Vec2>>& closed) const {
    return isOpenPlane() ? std::vector<Vec2>()
                         : plannerFor(radius)->planAround(start, goal, closed);
  }
  bool isReachable(double radius, const Vec2& start, const Vec2& goal) const {
    return isOpenPlane() || plannerFor(radius)->isReachable(start, goal);
  }
  bool isClear(double radius, const Vec2& from, const Vec2& to) const {
    return isOpenPlane() || plannerFor(radius)->isClear(from, to);
  }
  std::optional<Vec2> nearestFreePosition(double radius, const Vec2& point) const;
  /// Lower bound of the distance to the next wall [m], from the grid; a large value without
  /// obstacles.
  double clearance(const Vec2& point) const;
  /// There is no map and no obstacle.
  bool isOpenPlane() const { return layer_->field() == nullptr; }
  /// True: certainly no wall between the points. False: there may be one.
  bool isOpenBetween(const Vec2& from, const Vec2& to) const {
    return isOpenPlane() || layer_->blocks()->areFree(from, to);
  }

 private:
  std::shared_ptr<PathPlanner> plannerFor(double radius) const;

  std::vector<Vec2> places_;
  std::shared_ptr<NavigationLayerCache> layers_;
  std::shared_ptr<const NavigationLayer> layer_;
  int version_ = 0;
};

}  // namespace sim2d
