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
  std::string globalFrame = "map";
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

/// The inflation layer that Nav2 had until Kilted, which Lyrical keeps under this name: cells are
/// reached over their four neighbours, so the source of a cost is not always the nearest.
struct LegacyInflationLayerParameters : InflationLayerParameters {};

/// An inflation that falls off by another rate on each side of the robot's path.
struct AsymmetricInflationLayerParameters {
  bool enabled = true;
  double inflationRadius = 2.0;         // [m]
  double costScalingFactorLeft = 4.0;   // [1/m]
  double costScalingFactorRight = 4.0;  // [1/m]
  double goalDistanceThreshold = 1.5;   // [m]
  bool inflateUnknown = false, inflateAroundUnknown = false;
};

/// Removes small groups of lethal cells.
struct DenoiseLayerParameters {
  bool enabled = true;
  int minimalGroupSize = 2;       // [cells]; up to 1: nothing is removed
  int groupConnectivityType = 8;  // 4 or 8 neighbours
};

/// Probabilities of cells from the readings of sonars and other range sensors.
struct RangeSensorLayerParameters {
  bool enabled = true;
  double phi = 1.2;              // distance at which a reading counts half [m]
  double inflateCone = 1.0;      // share of the cone's area beyond it; 1: the whole box round it
  double noReadingsTimeout = 0;  // [s]; 0: never stale
  double clearThreshold = 0.2, markThreshold = 0.8;  // probabilities
  bool clearOnMaxReading = false;
  std::string inputSensorType = "ALL";  // VARIABLE, FIXED or ALL
  std::vector<std::string> topics;
};

/// Of a spatio-temporal voxel layer: one sensor as it takes it.
struct DecaySource {
  std::string name = "scan";  // no key: from observation_sources
  std::string topic;          // empty: the name
  bool enabled = true, marking = true, clearing = false, infIsValid = false;
  double observationPersistence = 0.0, expectedUpdateRate = 0.0;  // [s]
  double minObstacleHeight = 0.0, maxObstacleHeight = 3.0;        // [m]
  double obstacleRange = 2.5;                                     // [m], marking
  double minZ = 0.0, maxZ = 10.0;       // of the field of view, along the sensor's axis [m]
  double horizontalFieldOfView = 1.04;  // [rad]
  double decayAcceleration = 0.0;       // [1/s²]
  int modelType = 0;                    // 0 depth camera, 1 lidar
};

/// A grid of voxels that forget what was marked after some time (spatio_temporal_voxel_layer by S.
/// Macenski).
struct DecayLayerParameters {
  bool enabled = true;
  double voxelDecay = -1.0;   // [s]
  int decayModel = 0;         // 0 linear, 1 exponential, others: voxels do not decay
  double voxelSize = 0.05;    // [m]
  int combinationMethod = 1;  // 0 overwrite, others maximum
  bool updateFootprintEnabled = true;
  std::string observationSources;
  std::vector<DecaySource> sources;  // no key: the blocks named by observation_sources
};

struct CostmapPlugin;

/// A costmap of layers of its own, which is merged as one.
struct ContainerLayerParameters {
  bool enabled = true;
  int combinationMethod = 1;  // 0 overwrite, 1 maximum, 2 maximum where known
  std::vector<std::string> plugins;
  std::vector<CostmapPlugin> layers;  // no key: those of `plugins`
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
  std::string filterInfoTopic;
  std::string maskFile;          // the YAML of a map, relative to the file; empty: no mask
  bool isMaskPublished = false;  // by a node of the file, on the topic
};

struct SpeedFilterParameters {
  bool enabled = true;
  std::string filterInfoTopic;
  std::string maskFile;  // as above
  bool isMaskPublished = false;
  double maskBase = 0.0, maskMultiplier = 1.0;  // limit = base + multiplier * value
  bool maskIsPercentage = true;                 // of the full speed, else [m/s]
};

struct BinaryFilterParameters {
  bool enabled = true;
  bool defaultState = false;
  double flipThreshold = 50.0;  // of base + multiplier * value
  std::string filterInfoTopic;
  std::string maskFile;  // as above
  bool isMaskPublished = false;
  double maskBase = 0.0, maskMultiplier = 1.0;  // ours, as above
};

using LayerParameters =
    std::variant<StaticLayerParameters, ObstacleLayerParameters, VoxelLayerParameters,
                 InflationLayerParameters, SocialLayerParameters, KeepoutFilterParameters,
                 SpeedFilterParameters, LegacyInflationLayerParameters,
                 AsymmetricInflationLayerParameters, DenoiseLayerParameters,
                 RangeSensorLayerParameters, DecayLayerParameters, ContainerLayerParameters,
                 BinaryFilterParameters>;

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
const std::vector<Nav2Key<LegacyInflationLayerParameters>>& legacyInflationLayerKeys();
const std::vector<Nav2Key<AsymmetricInflationLayerParameters>>& asymmetricInflationLayerKeys();
const std::vector<Nav2Key<DenoiseLayerParameters>>& denoiseLayerKeys();
const std::vector<Nav2Key<RangeSensorLayerParameters>>& rangeSensorLayerKeys();
const std::vector<Nav2Key<DecaySource>>& decaySourceKeys();
const std::vector<Nav2Key<DecayLayerParameters>>& decayLayerKeys();
const std::vector<Nav2Key<ContainerLayerParameters>>& containerLayerKeys();
const std::vector<Nav2Key<BinaryFilterParameters>>& binaryFilterKeys();
const std::vector<IdleKey>& idleDecayKeys();        // of a spatio-temporal voxel layer
const std::vector<IdleKey>& idleDecaySourceKeys();  // of one of its sources
const std::vector<IdleKey>& idleCostmapKeys();
const std::vector<IdleKey>& idleLayerKeys();   // of any layer or filter
const std::vector<IdleKey>& idleSourceKeys();  // of an observation source

}  // namespace sim2d::nav2
