#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
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
/// Calls `visit(Cell)` for each cell, row by row from the lower left.
template <class Visit>
void forEachCell(const CellWindow& window, const Visit& visit) {
  for (int row = window.bottom; row < window.top; ++row) {
    for (int column = window.left; column < window.right; ++column) {
      visit(Cell{column, row});
    }
  }
}

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

/// The state that a binary filter publishes.
struct BinaryState {
  bool state = false;
  int changes = 0;  // number of changes so far
};

/// The decay of costs around lethal cells (nav2_costmap_2d, inflation_layer.hpp, computeCost).
struct InflationCostFunction {
  double radius = 0.55;    // maximum distance [m]
  double scaling = 10.0;   // cost_scaling_factor [1/m]
  double inscribed = 0.1;  // r_in of the robot [m]

  /// Cost at a distance between cell centres [m]: 254 at 0, 253 up to r_in, then trunc(252
  /// exp(-scaling (d - r_in))), also beyond `radius`.
  std::uint8_t cost(double distance) const;
  /// The inverse, as in MPPI's ObstaclesCritic and Regulated Pure Pursuit: r_in - ln(cost / 253) /
  /// scaling for costs in [1, 253] [m]; measured from the robot's centre.
  double distance(std::uint8_t cost) const;
};

/// Parameters of a costmap and the properties of its robot and map.
struct CostmapSetup {
  CostmapSettings settings;
  OccupancyGrid map;         // for static layers; empty: no effect
  double lidarHeight = 0.2;  // above the floor [m]
  FilterMasks masks;         // a filter without a mask has no effect
  Distro distro = Distro::Humble;
};

/// Data shared by all layers of one costmap; outlives them.
struct CostmapContext {
  Distro distro = Distro::Humble;
  CostmapFootprint footprint;
  bool isRolling = false, tracksUnknown = false;
  double lidarHeight = 0.2;  // [m]
  std::uint8_t defaultCost() const { return tracksUnknown ? kNoInformation : kFreeSpace; }
};

/// What a layer is created for.
struct LayerSite {
  std::string name;
  const CostmapContext& context;  // outlives the layer
  const Costmap& master;          // size and origin of the costmap
  const CostmapSetup& setup;
};

/// Transforms a point of a costmap into the map frame; `frame` is the costmap's frame in the map.
inline Vec2 pointInMap(const Pose2& frame, const Vec2& point) {
  return isIdentity(frame) ? point : frame.toWorld(point);
}

/// A plugin of a costmap. Call order: `observe` at each step; at an update `updateBounds` of all
/// layers, then `updateCosts` of all layers in the window that results from the bounds.
class CostmapLayer {
 public:
  explicit CostmapLayer(const LayerSite& site) : name_(site.name), context_(site.context) {}
  virtual ~CostmapLayer() = default;
  CostmapLayer(const CostmapLayer&) = delete;
  CostmapLayer& operator=(const CostmapLayer&) = delete;
  CostmapLayer(CostmapLayer&&) = delete;
  CostmapLayer& operator=(CostmapLayer&&) = delete;

  virtual void observe(const Observation& /*observation*/) {}
  virtual void updateBounds(const Observation& /*observation*/, const Costmap& /*master*/,
                            CostmapBounds& /*bounds*/) {}
  virtual void updateCosts(Costmap& /*master*/, const CellWindow& /*window*/) {}
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
  /// The cost function if this is the inflation layer of that name, or any one if it is empty.
  virtual std::optional<InflationCostFunction> inflation(const std::string& /*name*/) const {
    return std::nullopt;
  }
  /// Speed filters: the limit if it has changed since the last call.
  virtual std::optional<SpeedLimit> takeNewLimit() { return std::nullopt; }
  /// Binary filters: the state.
  virtual std::optional<BinaryState> binaryState() const { return std::nullopt; }

  const std::string& name() const { return name_; }

 protected:
  const CostmapContext& context() const { return context_; }
  /// The area under the robot in world frame, which the layer clears and which is added to the
  /// bounds; empty if the layer does not clear.
  Polygon clearedFootprint(bool isCleared, const Observation& observation,
                           CostmapBounds& bounds) const;

 private:
  std::string name_;
  const CostmapContext& context_;
};

/// A layer with a grid of its own that can be cleared.
class GridLayer : public CostmapLayer {
 public:
  /// `emptyCost`: cost of cells without data.
  GridLayer(const LayerSite& site, bool isEnabled, std::uint8_t emptyCost);

  bool isCurrent() const override { return isCurrent_ || !isEnabled_; }
  bool isClearable() const override { return true; }
  const Costmap* grid() const override { return &grid_; }

 protected:
  void emptyGrid();
  /// Empties the grid, which is then out of date until the next update.
  void resetGrid();
  /// Moves the grid to the window of a costmap that moves with the robot.
  void moveWithRobot(const Observation& observation, const Costmap& master);

  bool isEnabled_;
  std::uint8_t emptyCost_;
  Costmap grid_;
  bool isCurrent_ = true, wasReset_ = false;
};

/// A scan as points in the world frame.
struct PointCloud {
  Vec2 origin = Vec2::Zero();  // sensor position [m]
  double time = 0.0;           // [s]
  std::vector<Vec2> points;    // [m]
};

/// The scans of one source of a layer (nav2_costmap_2d, observation_buffer.cpp).
/// Distances of `LaserScan::range` correspond to ROS's infinite ones.
class ObservationBuffer {
 public:
  ObservationBuffer(const ObservationSource& source, double lidarHeight)
      : source_(source), lidarHeight_(lidarHeight) {}

  /// Called each step: stores the scan if it is newer than the last one.
  void observe(const LaserScan& scan);
  /// The scans that are valid at a time, newest first.
  const std::deque<PointCloud>& clouds(double time);
  /// Whether the last scan is no older than `expected_update_rate`.
  bool isCurrent(double time) const;
  void resetLastUpdated(double time) { lastTime_ = time; }

  const ObservationSource& source() const { return source_; }

 private:
  ObservationSource source_;
  double lidarHeight_;      // [m]
  double lastScan_ = -1.0;  // [s], stamp of the newest scan
  double lastTime_ = 0.0;   // [s], of the newest scan or the start
  std::deque<PointCloud> clouds_;
};

using LayerPointer = std::unique_ptr<CostmapLayer>;

/// Creates a layer or filter; private to this folder, as are the functions for each type of
/// parameters, each of which is in the source of its layer.
LayerPointer makeLayer(const CostmapPlugin& plugin, const CostmapContext& context,
                       const Costmap& master, const CostmapSetup& setup);
LayerPointer makeLayer(const StaticLayerParameters& parameters, const LayerSite& site);
LayerPointer makeLayer(const ObstacleLayerParameters& parameters, const LayerSite& site);
LayerPointer makeLayer(const VoxelLayerParameters& parameters, const LayerSite& site);
LayerPointer makeLayer(const InflationLayerParameters& parameters, const LayerSite& site);
LayerPointer makeLayer(const LegacyInflationLayerParameters& parameters, const LayerSite& site);
LayerPointer makeLayer(const AsymmetricInflationLayerParameters& parameters, const LayerSite& site);
LayerPointer makeLayer(const DenoiseLayerParameters& parameters, const LayerSite& site);
LayerPointer makeLayer(const RangeSensorLayerParameters& parameters, const LayerSite& site);
LayerPointer makeLayer(const SpatioTemporalVoxelLayerParameters& parameters, const LayerSite& site);
LayerPointer makeLayer(const PluginContainerLayerParameters& parameters, const LayerSite& site);
LayerPointer makeLayer(const SocialLayerParameters& parameters, const LayerSite& site);
LayerPointer makeLayer(const KeepoutFilterParameters& parameters, const LayerSite& site);
LayerPointer makeLayer(const SpeedFilterParameters& parameters, const LayerSite& site);
LayerPointer makeLayer(const BinaryFilterParameters& parameters, const LayerSite& site);

/// The cost of an occupancy value (StaticLayer::interpretValue); `parameters` are those of the
/// costmap's node.
std::uint8_t costOfOccupancy(std::int8_t occupancy, const CostmapParameters& parameters,
                             Distro distro);
/// An axis-aligned costmap of a map; cells off a rotated map are unknown.
Costmap costmapFromMap(const OccupancyGrid& map, const CostmapParameters& parameters,
                       Distro distro);

/// The sensor model of range sensor layers: probability [0, 1] that a cell at `distance` [m] and
/// `angle` [rad] from the axis is occupied, given a reading of `range` [m] by a sensor with half
/// angle `halfAngle` [rad]. `phi` [m] is the key of that name, `resolution` [m] the cell size.
double sonarOccupancy(double range, double distance, double angle, double halfAngle, double phi,
                      double resolution);
/// The axis of the range sensor of this name relative to the robot's heading [rad].
double directionOfSensor(const std::string& topic);

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
