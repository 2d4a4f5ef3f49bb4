#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/nav/FrameTransform.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

/// The interface of costmap layers and the types that they share.
namespace sim2d::nav2 {

/// The area that an update affects [m]; initially empty.
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

/// Cells from (left, bottom) inclusive to (right, top) exclusive.
struct CellWindow {
  int left = 0, bottom = 0, right = 0, top = 0;

  bool contains(Cell cell) const {
    return cell.column >= left && cell.column < right && cell.row >= bottom && cell.row < top;
  }
};

/// The mask of a filter (nav2 CostmapFilterInfo): occupancy -> base + multiplier * value.
struct FilterMask {
  OccupancyGrid grid;  // 0 to 100; -1 is unknown
  double base = 0.0, multiplier = 1.0;
  bool isPercentage = true;  // speeds are percentages of the maximum, else [m/s]
};

using FilterMasks = std::map<std::string, FilterMask>;  // keys are filter names

/// A speed limit as Nav2 sends it to controllers; 0 = none.
struct SpeedLimit {
  double value = 0.0;  // [%] or [m/s]
  bool isPercentage = true;
  friend bool operator==(const SpeedLimit& a, const SpeedLimit& b) {
    return a.value == b.value && a.isPercentage == b.isPercentage;
  }
};

/// Data shared by all layers of one costmap; outlives them.
struct CostmapContext {
  Distro distro = Distro::Humble;
  CostmapFootprint footprint;
  bool isRolling = false, tracksUnknown = false;
  double lidarHeight = 0.2;  // [m]
  std::uint8_t defaultCost() const { return tracksUnknown ? kNoInformation : kFreeSpace; }
};

/// Transforms a point of a costmap into the map frame; `frame` is the costmap's frame in the map.
inline Vec2 pointInMap(const Pose2& frame, const Vec2& point) {
  return isIdentity(frame) ? point : frame.toWorld(point);
}

/// A plugin of a costmap. Call order: `observe` at each step; at an update `updateBounds` of all
/// layers, then `updateCosts` of all layers in the window that results from the bounds.
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
  /// Restores the initial state at a time [s].
  virtual void reset(double /*time*/) {}
  /// Whether the layer's data are up to date.
  virtual bool isCurrent() const { return true; }
  /// Whether `clearArea` has an effect.
  virtual bool isClearable() const { return false; }
  /// Clears the cells strictly between two corners, or all others if `isInverted`.
  virtual void clearArea(const Vec2& /*low*/, const Vec2& /*high*/, bool /*isInverted*/) {}
  /// Called with each new path that the robot follows.
  virtual void setPlan(const Path& /*plan*/) {}
  /// The layer's own grid, for display; may be null.
  virtual const Costmap* grid() const { return nullptr; }

  const std::string& name() const { return name_; }

 protected:
  const CostmapContext& context() const { return context_; }
  /// Moves the layer's grid to the window of a costmap that moves with the robot; new cells get
  /// `cost`.
  void moveWithRobot(Costmap& grid, const Observation& observation, const Costmap& master,
                     std::uint8_t cost) const;
  /// The area under the robot in world frame, which the layer clears and which is added to the
  /// bounds; empty if the layer does not clear.
  Polygon clearedFootprint(bool isCleared, const Observation& observation,
                           CostmapBounds& bounds) const;

 private:
  std::string name_;
  const CostmapContext& context_;
};

/// Grid operations shared by the layers (nav2_costmap_2d, costmap_2d.cpp, costmap_layer.cpp).

/// Width and height as computed by Nav2: (cells - 1/2) * resolution [m].
Vec2 nav2SizeOf(const Costmap& costmap);
/// Moves the lower left corner towards `origin` by whole cells, rounded towards 0. Cells that stay
/// inside keep their costs, the others become `defaultCost`.
void moveOrigin(Costmap& costmap, const Vec2& origin, std::uint8_t defaultCost);
/// Returns the cell at a position, or the nearest border cell along each axis.
Cell nearestCell(const Costmap& costmap, const Vec2& place);
/// Returns the cells in the bounds; empty when there are none.
CellWindow windowOf(const Costmap& costmap, const CostmapBounds& bounds);
inline CellWindow wholeWindow(const Costmap& costmap) {
  return {0, 0, costmap.width(), costmap.height()};
}

void fillWindow(Costmap& costmap, const CellWindow& window, std::uint8_t cost);
/// Methods to merge a grid into one of equal size (combination_method 0, 1, 2, and an exact copy).
enum class CombinationMethod : std::uint8_t { Overwrite, Maximum, MaximumOfKnown, Copy };
void mergeWindow(const Costmap& from, const CellWindow& window, CombinationMethod way,
                 Costmap& into);
/// The same with the value of a parameter file; values other than 0, 1, 2 have no effect.
void mergeWindow(const Costmap& from, const CellWindow& window, int combinationMethod,
                 Costmap& into);
/// Sets the cells strictly between two corners, or all others if `isInverted`.
void clearCells(Costmap& costmap, const Vec2& low, const Vec2& high, bool isInverted,
                std::uint8_t cost);

/// Fills a convex polygon in world frame including its edges. No effect if a corner is off the map.
void fillPolygon(Costmap& costmap, const Polygon& polygon, std::uint8_t cost);

}  // namespace sim2d::nav2
