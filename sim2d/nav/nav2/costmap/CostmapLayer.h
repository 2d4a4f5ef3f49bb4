#pragma once

#include <limits>
#include <map>
#include <string>
#include <utility>

#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/nav/FrameTransform.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2Key.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

/// What layers of a costmap are to it.
namespace sim2d::nav2 {

/// Places that an update has to look at [m]; empty at first.
struct CostmapBounds {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::max());
  Vec2 high = Vec2::Constant(std::numeric_limits<double>::lowest());

  void touch(const Vec2& place) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  void touch(const CostmapBounds& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
};
inline CostmapBounds unboundedBounds() {
  const CostmapBounds none;
  return {none.high, none.low};
}

/// Cells from (left, bottom) up to, not with, (right, top).
struct CellWindow {
  int left = 0, bottom = 0, right = 0, top = 0;
};

/// The mask of a filter (nav2 CostmapFilterInfo): occupancy -> base + multiplier * value.
struct FilterMask {
  OccupancyGrid grid;  // of which 100 is most, -1 nothing
  double base = 0.0, multiplier = 1.0;
  bool isPercentage = true;  // of a speed: percent of the full one, else [m/s]
};

using FilterMasks = std::map<std::string, FilterMask>;  // by the names of filters

/// What Nav2 sends to controllers: 0 = none.
struct SpeedLimit {
  double value = 0.0;  // [%] or [m/s]
  bool isPercentage = true;
  friend bool operator==(const SpeedLimit& a, const SpeedLimit& b) {
    return a.value == b.value && a.isPercentage == b.isPercentage;
  }
};

/// What all layers of one costmap share; lives as long as they do.
struct CostmapContext {
  Distro distro = Distro::Humble;
  CostmapFootprint footprint;
  bool isRolling = false, tracksUnknown = false;
  double lidarHeight = 0.2;  // [m]
  std::uint8_t freshCost() const { return tracksUnknown ? kNoInformation : kFreeSpace; }
};

/// A point of a costmap in the map, where `frame` is the costmap's frame in the map.
inline Vec2 pointInMap(const Pose2& frame, const Vec2& point) {
  return isIdentity(frame) ? point : frame.toWorld(point);
}

/// A plugin of a costmap. Called in this order: `observe` at each step; at an update `updateBounds`
/// of all, then `updateCosts` of all in the window that comes of the bounds.
class CostmapLayer {
 public:
  CostmapLayer(std::string name, const CostmapContext& context)
      : name_(std::move(name)), context_(context) {}
  virtual ~CostmapLayer() = default;
  CostmapLayer(const CostmapLayer&) = delete;
  CostmapLayer& operator=(const CostmapLayer&) = delete;
  CostmapLayer(CostmapLayer&&) = delete;
  CostmapLayer& operator=(CostmapLayer&&) = delete;

  virtual void observe(const Observation& /*observation*/) {}
  virtual void updateBounds(const Observation& observation, const Costmap& master,
                            CostmapBounds& bounds) = 0;
  virtual void updateCosts(Costmap& master, const CellWindow& window) = 0;
  /// As after its making, at a time [s].
  virtual void reset(double /*time*/) {}
  /// Whether what it says is fresh.
  virtual bool isCurrent() const { return true; }
  /// Whether `clearArea` forgets something.
  virtual bool isClearable() const { return false; }
  /// Forgets the cells strictly between two corners, or with `isInverted` all others.
  virtual void clearArea(const Vec2& /*low*/, const Vec2& /*high*/, bool /*isInverted*/) {}
  /// The path that the robot follows, whenever there is a new one.
  virtual void setPlan(const Path& /*plan*/) {}
  /// Its own grid, for display; null: none.
  virtual const Costmap* grid() const { return nullptr; }

  const std::string& name() const { return name_; }

 protected:
  const CostmapContext& context() const { return context_; }

 private:
  std::string name_;
  const CostmapContext& context_;
};

}  // namespace sim2d::nav2
