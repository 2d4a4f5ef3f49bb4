#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim2d/nav/nav2/Nav2Key.h"

/// What a costmap is made of, as nav2_params.yaml has it; defaults are those of Nav2's code.
namespace sim2d::nav2 {

/// Keys of the costmap's node itself.
struct CostmapParameters {
  double updateFrequency = 5.0, publishFrequency = 1.0;  // [Hz]
  int width = 5, height = 5;                             // [m]
  double resolution = 0.1;                               // [m]
  double originX = 0.0, originY = 0.0;                   // [m]
  bool rollingWindow = false, trackUnknownSpace = false;
  double robotRadius = 0.1;        // [m]; counts only without a footprint
  std::string footprint = "[]";    // "[[x, y], …]" [m]
  double footprintPadding = 0.01;  // [m]
  std::vector<std::string> plugins = {"static_layer", "obstacle_layer", "inflation_layer"};
  std::vector<std::string> filters;
  int unknownCostValue = 255, lethalCostThreshold = 100;  // of occupancies
  bool trinaryCostmap = true;
  int inscribedObstacleCostValue = 99;  // of occupancies; main only
  bool useMaximum = false;
};

struct StaticLayerParameters {
  bool enabled = true;
  bool footprintClearingEnabled = false, restoreClearedFootprint = true;
};

/// Of an obstacle layer: one lidar as it takes it.
struct ObservationSource {
  std::string name = "scan";  // no key: from observation_sources
  std::string topic;          // empty: the name
  std::string dataType = "LaserScan";
  double observationPersistence = 0.0;                      // [s]; 0: the newest scan only
  double expectedUpdateRate = 0.0;                          // [s]; 0: never stale
  double minObstacleHeight = 0.0, maxObstacleHeight = 0.0;  // [m]
  bool infIsValid = false, marking = true, clearing = false;
  double obstacleMaxRange = 2.5, obstacleMinRange = 0.0;  // [m], marking
  double raytraceMaxRange = 3.0, raytraceMinRange = 0.0;  // [m], clearing
};

struct ObstacleLayerParameters {
  bool enabled = true, footprintClearingEnabled = true;
  double minObstacleHeight = 0.0, maxObstacleHeight = 2.0;  // [m]
  int combinationMethod = 1;  // 0 overwrite, 1 maximum, 2 maximum where known
  std::string observationSources;
  std::vector<ObservationSource> sources;  // no key: the blocks named by observation_sources
};

/// An obstacle layer whose rays end short of what they hit.
struct VoxelLayerParameters : ObstacleLayerParameters {
  double originZ = 0.0, zResolution = 0.2;  // [m]
  int zVoxels = 10, markThreshold = 0;
};

struct InflationLayerParameters {
  bool enabled = true;
  double inflationRadius = 0.55;    // [m]
  double costScalingFactor = 10.0;  // [1/m]
  bool inflateUnknown = false, inflateAroundUnknown = false;
  double customInscribedRadius = -1.0;  // [m]; below 0: the footprint's; main only
};

/// Costs round people, ours: asymmetric Gaussians (Kirby 2010, Social Robot Navigation, PhD thesis,
/// Carnegie Mellon University). Ahead sigma = max(sigmaPerSpeed * v, sigmaMin).
struct SocialLayerParameters {
  bool enabled = true;
  double amplitude = 252.0;      // cost at the person's centre; below 253 it is never a collision
  double sigmaPerSpeed = 2.0;    // [s]
  double sigmaMin = 0.5;         // [m]
  double sideRatio = 2.0 / 3.0;  // sigma to the sides / ahead
  double rearRatio = 0.5;        // sigma behind / ahead
  double cutoff = 10.0;          // lower costs are left out
};

struct KeepoutFilterParameters {
  bool enabled = true;
  bool overrideLethalCost = false;
  int lethalOverrideCost = 252;
  std::string maskFile;  // ours: the YAML of a map, relative to the file; empty: no mask
};

struct SpeedFilterParameters {
  bool enabled = true;
  std::string maskFile;                         // ours, as above
  double maskBase = 0.0, maskMultiplier = 1.0;  // ours: limit = base + multiplier * value
  bool maskIsPercentage = true;                 // ours: of the full speed, else [m/s]
};

using LayerParameters =
    std::variant<StaticLayerParameters, ObstacleLayerParameters, VoxelLayerParameters,
                 InflationLayerParameters, SocialLayerParameters, KeepoutFilterParameters,
                 SpeedFilterParameters>;

/// One of `plugins` or `filters`.
struct CostmapPlugin {
  std::string name;  // "inflation_layer"
  LayerParameters parameters;
};

/// A costmap with its plugins, each list in the order of the file, which is that of the update.
struct CostmapSettings {
  CostmapParameters parameters;
  std::vector<CostmapPlugin> plugins, filters;
};
/// With the plugins that Nav2 loads when the file names none.
CostmapSettings defaultCostmapSettings();

/// Defaults of a type as files have it ("nav2_costmap_2d::InflationLayer"), ours is
/// "hunavsim::SocialLayer"; nothing for what is not supported.
std::optional<LayerParameters> layerOfType(std::string_view type);
std::string_view typeOf(const LayerParameters& parameters);
std::vector<std::string> layerTypes();

// The tables. Those of an obstacle layer are without its sources; `<name>.` stands before each key.
const std::vector<Nav2Key<CostmapParameters>>& costmapKeys();
const std::vector<Nav2Key<StaticLayerParameters>>& staticLayerKeys();
const std::vector<Nav2Key<ObservationSource>>& observationSourceKeys();
const std::vector<Nav2Key<ObstacleLayerParameters>>& obstacleLayerKeys();
const std::vector<Nav2Key<VoxelLayerParameters>>& voxelLayerKeys();
const std::vector<Nav2Key<InflationLayerParameters>>& inflationLayerKeys();
const std::vector<Nav2Key<SocialLayerParameters>>& socialLayerKeys();
const std::vector<Nav2Key<KeepoutFilterParameters>>& keepoutFilterKeys();
const std::vector<Nav2Key<SpeedFilterParameters>>& speedFilterKeys();
const std::vector<IdleKey>& idleCostmapKeys();
const std::vector<IdleKey>& idleLayerKeys();   // of any layer or filter
const std::vector<IdleKey>& idleSourceKeys();  // of an observation source

}  // namespace sim2d::nav2
