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

/// Which blocks of cells no wall reaches into, so that a line of sight across such blocks alone
/// needs no look at the walls. Immutable; thread: any.
class OpenBlocks {
 public:
  explicit OpenBlocks(std::shared_ptr<const DistanceField> field);

  /// True: no wall stands in the rectangle, along the grid, about the two points. False: one may.
  bool areFree(const Vec2& from, const Vec2& to) const;

 private:
  int wallsBelow(int column, int row) const;

  std::shared_ptr<const DistanceField> field_;
  int width_ = 0, height_ = 0;  // blocks
  double perCell_ = 1.0;        // blocks
  std::vector<int> below_;  // blocks with walls of lower column and row, (width + 1) x (height + 1)
};

/// What routes take of a map and all that stands on it, for one state of its doors. Made once and
/// shared by all who plan there; planners come as radii are asked for, and those that have not been
/// asked for longest go when all take more than `mostBytes`. Thread: any.
class NavigationLayer {
 public:
  /// `places`: starts and goals; they bound the plane where there is no map.
  NavigationLayer(const OccupancyGrid& map, const Obstacles& obstacles,
                  const std::vector<Vec2>& places, base::StopFlagPtr stop,
                  const std::shared_ptr<const CellDistances>& walls,
                  std::size_t mostBytes = kMostBytes);
  static constexpr std::size_t kMostBytes = std::size_t{1} << 30U;

  const DistanceField* field() const { return field_.get(); }  // null: nothing stands anywhere
  const OpenBlocks* blocks() const { return blocks_.get(); }   // idem
  /// Where something stands.
  std::shared_ptr<PathPlanner> plannerFor(double radius) const;
  /// Memory taken, but for the cells of the map.
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

/// The layers of one map and what stands on it, by the state of the doors; the last ones are kept
/// within `mostBytes`, and of ordinary maps the distances to walls, which no door alters.
/// Thread: any.
class NavigationLayers {
 public:
  /// `stop`: ends the work on layers, by `base::Stopped`.
  explicit NavigationLayers(base::StopFlagPtr stop = std::make_shared<const base::StopFlag>(),
                            std::size_t mostBytes = NavigationLayer::kMostBytes)
      : stop_(std::move(stop)), mostBytes_(mostBytes) {}
  std::shared_ptr<const NavigationLayer> of(const OccupancyGrid& map, const Obstacles& obstacles,
                                            const std::vector<Vec2>& places);
  const base::StopFlagPtr& stopFlag() const { return stop_; }

 private:
  struct Entry {
    std::vector<char> enabled;  // by part
    std::vector<Vec2> places;   // without a map
    std::shared_ptr<const NavigationLayer> layer;
  };
  const base::StopFlagPtr stop_;
  const std::size_t mostBytes_;
  std::mutex mutex_;
  std::shared_ptr<const CellDistances> walls_;  // of an ordinary map, for all layers
  std::list<Entry> entries_;                    // last used first
};

/// Routes round walls for bodies of every radius, over what stands now. Thread: one at a time.
class NavigationMap {
 public:
  /// `layers`: of this map and these obstacles; null: its own.
  NavigationMap(const OccupancyGrid& map, const Obstacles& obstacles, std::vector<Vec2> places,
                std::shared_ptr<NavigationLayers> layers = nullptr);
  /// After doors were switched.
  void update(const OccupancyGrid& map, const Obstacles& obstacles);
  /// Counts the calls of `update`; routes from before are out of date.
  int version() const { return version_; }

  /// From start to goal; empty when there is none.
  std::vector<Vec2> plan(double radius, const Vec2& start, const Vec2& goal) const;
  /// The same, and out of convex polygons; none may hold the start or the goal; empty as well where
  /// nothing else stands: there is room to pass.
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
  std::optional<Vec2> nearestFit(double radius, const Vec2& point) const;
  /// At least this much room to the next wall [m], by the grid; large where nothing stands.
  double clearance(const Vec2& point) const;
  /// Nothing stands anywhere.
  bool isOpenPlane() const { return layer_->field() == nullptr; }
  /// True: surely no wall between the two; false: perhaps one.
  bool isOpenBetween(const Vec2& from, const Vec2& to) const {
    return isOpenPlane() || layer_->blocks()->areFree(from, to);
  }

 private:
  std::shared_ptr<PathPlanner> plannerFor(double radius) const;

  std::vector<Vec2> places_;
  std::shared_ptr<NavigationLayers> layers_;
  std::shared_ptr<const NavigationLayer> layer_;
  int version_ = 0;
};

}  // namespace sim2d
