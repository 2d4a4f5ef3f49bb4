#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
#include "sim2d/nav/nav2/costmap/InflationLaw.h"

namespace sim2d::nav2 {

/// What a costmap has to know of its robot and place.
struct CostmapSetup {
  CostmapSettings settings;
  OccupancyGrid map;         // of static layers; empty: they say nothing
  double lidarHeight = 0.2;  // over the floor [m]
  FilterMasks masks;         // none of a filter: it does nothing
  Distro distro = Distro::Humble;
};

/// What a binary filter publishes.
struct BinaryState {
  bool state = false;
  int changes = 0;  // so far
};

/// What is wrong with it, and what deserves a warning: sizes, footprint, an inflation that is cut,
/// a lidar whose height no source takes. Without errors it can be made.
base::Diagnostics problemsOf(const CostmapSetup& setup);

/// A costmap of Nav2 (nav2_costmap_2d: LayeredCostmap, Costmap2DROS, ClearCostmapService): layers
/// that are merged at `update_frequency`, and a copy of it that is published. World frame.
///
/// Non-rolling with a static layer and a map: cells as the map has them; a turned map is sampled
/// into cells along the axes. Else width x height metres from the origin, or round the robot.
///
/// Equal observations give equal costs, to the bit. Thread: one at a time.
class LayeredCostmap {
 public:
  explicit LayeredCostmap(const CostmapSetup& setup);  // without errors

  /// Each step: takes in a new scan; the n-th update is due at n / update_frequency and made at the
  /// first step not before that. Returns whether one was made.
  bool update(const Observation& observation);
  /// An update now, whatever the time.
  void updateNow(const Observation& observation);

  /// After the last update.
  const Costmap& costmap() const { return combined_; }
  /// What subscribers of the topic have: behaviours and smoothers. The copy is taken at the first
  /// update not before n / publish_frequency; never at 0 Hz, then it is the costmap itself.
  const Costmap& published() const;
  /// False after `clearEntirely` until the next update, and while a source is stale: planner and
  /// controller wait.
  bool isCurrent() const;
  std::int64_t updates() const { return updates_; }

  const CostmapFootprint& footprint() const { return context_->footprint; }
  bool tracksUnknown() const { return context_->tracksUnknown; }
  bool isRolling() const { return context_->isRolling; }
  /// Of the inflation layer with that name, or of the first one; nothing without one.
  std::optional<InflationLaw> inflation(const std::string& name = {}) const;
  /// Of the speed filters, the one that spoke last.
  const SpeedLimit& speedLimit() const { return speedLimit_; }
  /// By the names of the binary filters.
  std::map<std::string, BinaryState> binaryStates() const;
  /// The path that the robot follows: layers that depend on it use it in the next update.
  void setPlan(const Path& plan);
  const CostmapLayer* layer(const std::string& name) const;  // null: none has that name

  /// Service clear_entirely: all is as at the start, the costs at once. With `plugins` (main) those
  /// layers alone forget all, as below.
  bool clearEntirely(const std::vector<std::string>& plugins = {});
  /// Services clear_around and clear_except: obstacle layers forget what lies in the square of that
  /// side [m] round the robot's place, or all else. The costs follow with the next update.
  /// `plugins` (main): these alone, none = all; an unknown name or one that cannot be cleared:
  /// false, and nothing is cleared.
  bool clearAround(const Vec2& place, double side, const std::vector<std::string>& plugins = {});
  bool clearExcept(const Vec2& place, double side, const std::vector<std::string>& plugins = {});

 private:
  bool clearSquare(const Vec2& place, double side, bool isInverted,
                   const std::vector<std::string>& plugins);
  void updateMap(const Observation& observation);
  void publish(double time);

  std::unique_ptr<CostmapContext> context_;
  double updateFrequency_ = 5.0, publishFrequency_ = 1.0;  // [Hz]
  Costmap primary_, combined_, published_;  // plugins alone (with filters only); all; the copy
  std::vector<std::unique_ptr<CostmapLayer>> plugins_, filters_;
  SpeedLimit speedLimit_;
  double time_ = 0.0;                                                // [s], of the last step
  std::int64_t updates_ = 0, lastUpdate_ = -1, lastPublished_ = -1;  // numbers of events
};

}  // namespace sim2d::nav2
