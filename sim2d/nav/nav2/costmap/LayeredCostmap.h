#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"

namespace sim2d::nav2 {

/// Errors and warnings about sizes, footprint, an inflation radius below the inscribed radius, a
/// lidar outside the height range of all sources. A LayeredCostmap requires a setup without errors.
base::Diagnostics problemsOf(const CostmapSetup& setup);

/// A costmap of Nav2 (nav2_costmap_2d: LayeredCostmap, Costmap2DROS, ClearCostmapService): layers
/// that are merged at `update_frequency`, and a published copy. World frame.
///
/// A non-rolling costmap with a static layer and a map has the map's cells; a rotated map is
/// resampled into axis-aligned cells. Otherwise it has width x height metres from the origin, or
/// around the robot.
///
/// Equal observations give bit-identical costs. Not thread-safe.
class LayeredCostmap {
 public:
  explicit LayeredCostmap(const CostmapSetup& setup);  // precondition: no errors

  /// Called each step: observes new scans; the n-th update is due at n / update_frequency and
  /// happens at the first step not before that time. Returns whether an update happened.
  bool update(const Observation& observation);
  /// Updates immediately, regardless of the time.
  void updateNow(const Observation& observation);

  /// The costs after the last update.
  const Costmap& costmap() const { return combined_; }
  /// The copy that topic subscribers receive: behaviors and smoothers. It is taken at the first
  /// update not before n / publish_frequency; at 0 Hz it is the costmap itself.
  const Costmap& published() const;
  /// False after `clearEntirely` until the next update, and while a source is stale; planner and
  /// controller then wait.
  bool isCurrent() const;
  std::int64_t updates() const { return updates_; }

  const CostmapFootprint& footprint() const { return context_->footprint; }
  bool tracksUnknown() const { return context_->tracksUnknown; }
  bool isRolling() const { return context_->isRolling; }
  /// Cost function of the inflation layer of that name, or of the first one; nullopt if there is
  /// none.
  std::optional<InflationCostFunction> inflation(const std::string& name = {}) const;
  /// The latest limit of the speed filters.
  const SpeedLimit& speedLimit() const { return speedLimit_; }
  /// States of the binary filters by name.
  std::map<std::string, BinaryState> binaryStates() const;
  /// Sets the path that the robot follows; layers that depend on it use it in the next update.
  void setPlan(const Path& plan);
  const CostmapLayer* layer(const std::string& name) const;  // null: no such layer

  /// Service clear_entirely: resets all layers, and the costs immediately. With `plugins` (main)
  /// only these layers are cleared, as below.
  bool clearEntirely(const std::vector<std::string>& plugins = {});
  /// Services clear_around and clear_except: obstacle layers clear the square of that side [m]
  /// around the robot's position, or everything else. The costs follow with the next update.
  /// `plugins` (main): only these, empty = all; returns false without clearing if a name is unknown
  /// or not clearable.
  bool clearAround(const Vec2& place, double side, const std::vector<std::string>& plugins = {}) {
    return clearSquare(place, side, false, plugins);
  }
  bool clearExcept(const Vec2& place, double side, const std::vector<std::string>& plugins = {}) {
    return clearSquare(place, side, true, plugins);
  }

 private:
  bool clearSquare(const Vec2& place, double side, bool isInverted,
                   const std::vector<std::string>& plugins);
  void observe(const Observation& observation);
  void updateMap(const Observation& observation);
  void publish(double time);

  std::unique_ptr<CostmapContext> context_;
  double updateFrequency_ = 5.0, publishFrequency_ = 1.0;  // [Hz]
  Costmap primary_, combined_, published_;  // plugins only (if there are filters); all; the copy
  std::vector<LayerPointer> plugins_, filters_;
  SpeedLimit speedLimit_;
  double time_ = 0.0;                                                // [s], of the last step
  std::int64_t updates_ = 0, lastUpdate_ = -1, lastPublished_ = -1;  // event numbers
};

}  // namespace sim2d::nav2
