#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

/// Parameters of a costmap and its plugins, as in nav2_params.yaml; defaults are those of Nav2's
/// code.
namespace sim2d::nav2 {

/// Keys of the costmap's node.
struct CostmapParameters {
  double updateFrequency = 5.0, publishFrequency = 1.0;  // [Hz]
  int width = 5, height = 5;                             // [m]
  double resolution = 0.1;                               // [m]
  double originX = 0.0, originY = 0.0;                   // [m]
  bool rollingWindow = false, trackUnknownSpace = false;
  double robotRadius = 0.1;        // [m]; used only without a footprint
  std::string footprint = "[]";    // "[[x, y], …]" [m]
  double footprintPadding = 0.01;  // [m]
  std::vector<std::string> plugins = {"static_layer", "obstacle_layer", "inflation_layer"};
  std::vector<std::string> filters;
  int unknownCostValue = 255, lethalCostThreshold = 100;  // occupancies
  bool trinaryCostmap = true;
  int inscribedObstacleCostValue = 99;  // an occupancy; main only
  bool useMaximum = false;
  std::string globalFrame = "map";
};

struct StaticLayerParameters {
  bool enabled = true;
  bool footprintClearingEnabled = false, restoreClearedFootprint = true;
};

/// A sensor of an obstacle layer.
struct ObservationSource {
  std::string name = "scan";  // not a key: from observation_sources
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
  std::vector<ObservationSource> sources;  // not a key: the blocks named by observation_sources
};

/// An obstacle layer whose clearing rays end before the hit.
struct VoxelLayerParameters : ObstacleLayerParameters {
  double originZ = 0.0, zResolution = 0.2;  // [m]
  int zVoxels = 10, markThreshold = 0;
};

struct InflationLayerParameters {
  bool enabled = true;
  double inflationRadius = 0.55;    // [m]
  double costScalingFactor = 10.0;  // [1/m]
  bool inflateUnknown = false, inflateAroundUnknown = false;
  double customInscribedRadius = -1.0;  // [m]; negative: the footprint's radius; main only
};

/// Nav2's inflation layer until Kilted, kept in Lyrical under this name: it spreads over the four
/// neighbours of a cell, so the source of a cost is not always the nearest obstacle.
struct LegacyInflationLayerParameters : InflationLayerParameters {};

/// Inflation that decays at different rates on the two sides of the robot's path.
struct AsymmetricInflationLayerParameters : InflationLayerParameters {
  AsymmetricInflationLayerParameters() { inflationRadius = 2.0; }

  double costScalingFactorLeft = 4.0;   // [1/m]; replace costScalingFactor
  double costScalingFactorRight = 4.0;  // [1/m]
  double goalDistanceThreshold = 1.5;   // [m]
};

/// Removes small groups of lethal cells.
struct DenoiseLayerParameters {
  bool enabled = true;
  int minimalGroupSize = 2;       // [cells]; <= 1: nothing is removed
  int groupConnectivityType = 8;  // 4 or 8 neighbours
};

/// Occupancy probabilities from the readings of sonars and other range sensors.
struct RangeSensorLayerParameters {
  bool enabled = true;
  double phi = 1.2;              // distance at which a reading has half weight [m]
  double inflateCone = 1.0;      // widening of the cone relative to its area; 1: its bounding box
  double noReadingsTimeout = 0;  // [s]; 0: never stale
  double clearThreshold = 0.2, markThreshold = 0.8;  // probabilities
  bool clearOnMaxReading = false;
  std::string inputSensorType = "ALL";  // VARIABLE, FIXED or ALL
  std::vector<std::string> topics;
};

/// A sensor of a spatio-temporal voxel layer.
struct SpatioTemporalVoxelSource : ObservationSource {
  SpatioTemporalVoxelSource() { maxObstacleHeight = 3.0; }

  bool enabled = true;
  double obstacleRange = 2.5;           // [m], marking
  double minZ = 0.0, maxZ = 10.0;       // depth range of the field of view [m]
  double horizontalFieldOfView = 1.04;  // [rad]
  double decayAcceleration = 0.0;       // [1/s²]
  int modelType = 0;                    // 0 depth camera, 1 lidar
};

/// A grid of voxels whose marks expire (spatio_temporal_voxel_layer by S. Macenski).
struct SpatioTemporalVoxelLayerParameters {
  bool enabled = true;
  double voxelDecay = -1.0;   // [s]
  int decayModel = 0;         // 0 linear, 1 exponential, others: no decay
  double voxelSize = 0.05;    // [m]
  int combinationMethod = 1;  // 0 overwrite, others maximum
  bool updateFootprintEnabled = true;
  std::string observationSources;
  std::vector<SpatioTemporalVoxelSource>
      sources;  // not a key: the blocks named by observation_sources
};

struct CostmapPlugin;

/// Layers on their own costmap, which is merged like a single layer.
struct PluginContainerLayerParameters {
  bool enabled = true;
  int combinationMethod = 1;  // 0 overwrite, 1 maximum, 2 maximum where known
  std::vector<std::string> plugins;
  std::vector<CostmapPlugin> layers;  // not a key: those of `plugins`
};

/// Costs around people, specific to this program: asymmetric Gaussians (Kirby 2010, Social Robot
/// Navigation, PhD thesis, Carnegie Mellon University). Forward sigma = max(sigmaPerSpeed * v,
/// sigmaMin).
struct SocialLayerParameters {
  bool enabled = true;
  double amplitude = 252.0;      // cost at the person's centre; below 253 it is never a collision
  double sigmaPerSpeed = 2.0;    // [s]
  double sigmaMin = 0.5;         // [m]
  double sideRatio = 2.0 / 3.0;  // lateral / forward sigma
  double rearRatio = 0.5;        // rear / forward sigma
  double cutoff = 10.0;          // lower costs are omitted
};

/// Common parameters of the filters.
struct CostmapFilterParameters {
  bool enabled = true;
  std::string filterInfoTopic;
  std::string maskFile;          // YAML of a map, relative to the parameter file; empty: no mask
  bool isMaskPublished = false;  // by a node of the file, on the topic
  double maskBase = 0.0, maskMultiplier = 1.0;  // value of the filter = base + multiplier * mask
};

struct KeepoutFilterParameters : CostmapFilterParameters {
  bool overrideLethalCost = false;
  int lethalOverrideCost = 252;
};

struct SpeedFilterParameters : CostmapFilterParameters {
  bool maskIsPercentage = true;  // limits are percentages of the maximum speed, else [m/s]
};

struct BinaryFilterParameters : CostmapFilterParameters {
  bool defaultState = false;
  double flipThreshold = 50.0;  // of base + multiplier * value
};

using LayerParameters =
    std::variant<StaticLayerParameters, ObstacleLayerParameters, VoxelLayerParameters,
                 InflationLayerParameters, SocialLayerParameters, KeepoutFilterParameters,
                 SpeedFilterParameters, LegacyInflationLayerParameters,
                 AsymmetricInflationLayerParameters, DenoiseLayerParameters,
                 RangeSensorLayerParameters, SpatioTemporalVoxelLayerParameters,
                 PluginContainerLayerParameters, BinaryFilterParameters>;

/// An entry of `plugins` or `filters`.
struct CostmapPlugin {
  std::string name;  // "inflation_layer"
  LayerParameters parameters;
};

/// A costmap with its plugins, in the order of the file, which is the update order.
struct CostmapSettings {
  CostmapParameters parameters;
  std::vector<CostmapPlugin> plugins, filters;
};

/// The default parameters of a layer class ("nav2_costmap_2d::InflationLayer"; this program's own
/// is "hunavsim::SocialLayer"); nullopt for an unsupported class.
std::optional<LayerParameters> layerOfType(std::string_view type);
std::vector<std::string> layerTypes();

// Key tables. They do not contain the sources of obstacle layers; `<name>.` precedes each key.
Nav2Keys<CostmapParameters> costmapKeys();
Nav2Keys<StaticLayerParameters> keysOf(const StaticLayerParameters&);
Nav2Keys<ObservationSource> observationSourceKeys();
Nav2Keys<ObstacleLayerParameters> keysOf(const ObstacleLayerParameters&);
Nav2Keys<VoxelLayerParameters> keysOf(const VoxelLayerParameters&);
Nav2Keys<InflationLayerParameters> keysOf(const InflationLayerParameters&);
Nav2Keys<SocialLayerParameters> keysOf(const SocialLayerParameters&);
Nav2Keys<KeepoutFilterParameters> keysOf(const KeepoutFilterParameters&);
Nav2Keys<SpeedFilterParameters> keysOf(const SpeedFilterParameters&);
Nav2Keys<LegacyInflationLayerParameters> keysOf(const LegacyInflationLayerParameters&);
Nav2Keys<AsymmetricInflationLayerParameters> keysOf(const AsymmetricInflationLayerParameters&);
Nav2Keys<DenoiseLayerParameters> keysOf(const DenoiseLayerParameters&);
Nav2Keys<RangeSensorLayerParameters> keysOf(const RangeSensorLayerParameters&);
Nav2Keys<SpatioTemporalVoxelSource> spatioTemporalVoxelSourceKeys();
Nav2Keys<SpatioTemporalVoxelLayerParameters> keysOf(const SpatioTemporalVoxelLayerParameters&);
Nav2Keys<PluginContainerLayerParameters> keysOf(const PluginContainerLayerParameters&);
Nav2Keys<BinaryFilterParameters> keysOf(const BinaryFilterParameters&);
IgnoredKeys ignoredSpatioTemporalVoxelKeys();        // of a spatio-temporal voxel layer
IgnoredKeys ignoredSpatioTemporalVoxelSourceKeys();  // of one of its sources
IgnoredKeys ignoredCostmapKeys();
IgnoredKeys ignoredLayerKeys();   // of all layers and filters
IgnoredKeys ignoredSourceKeys();  // of an observation source

}  // namespace sim2d::nav2
