#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "sim2d/map/OpenBlocks.h"
#include "sim2d/map/PathPlanner.h"

namespace sim2d {

/// Ways round walls for bodies of every radius, over what stands now. Thread: one at a time.
class Ways {
 public:
  /// `places`: starts and goals; they bound the plane where there is no map.
  Ways(const OccupancyGrid& map, const Obstacles& obstacles, std::vector<Vec2> places);
  /// After doors were switched.
  void rebuild(const OccupancyGrid& map, const Obstacles& obstacles);
  /// Counts the calls of `rebuild`; ways from before are out of date.
  int version() const { return version_; }

  /// From start to goal; empty when there is none.
  std::vector<Vec2> plan(double radius, const Vec2& start, const Vec2& goal);
  bool isReachable(double radius, const Vec2& start, const Vec2& goal);
  bool isClear(double radius, const Vec2& from, const Vec2& to);
  std::optional<Vec2> nearestFit(double radius, const Vec2& point);
  /// At least this much room to the next wall [m], by the grid; large where nothing stands.
  double clearance(const Vec2& point) const;
  /// Nothing stands anywhere.
  bool areOpen() const { return field_ == nullptr; }
  /// True: surely no wall between the two; false: perhaps one.
  bool isOpenBetween(const Vec2& from, const Vec2& to) const {
    return blocks_ == nullptr || blocks_->areFree(from, to);
  }

 private:
  PathPlanner& plannerFor(double radius);

  std::vector<Vec2> places_;
  std::shared_ptr<const DistanceField> field_;                  // null: nothing stands anywhere
  std::unique_ptr<const OpenBlocks> blocks_;                    // of the field
  std::map<long long, std::unique_ptr<PathPlanner>> planners_;  // by radius [mm]
  int version_ = 0;
};

}  // namespace sim2d
