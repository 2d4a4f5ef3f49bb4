#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"
#include "sim2d/nav/nav2/costmap/LayeredCostmap.h"

namespace sim2d::nav2 {
namespace {

constexpr int kMaxCells = 4000;                      // along one side
constexpr base::Range kSideRange{0.005, 10.0};       // cell size [m]
constexpr base::Range kLengthRange{1.0, 1000.0};     // costmap size [m]
constexpr base::Range kPlaceRange{-1e6, 1e6};        // costmap origin [m]
constexpr base::Range kFrequencyRange{0.0, 1000.0};  // [Hz]
constexpr base::Range kPublishRange{-1.0, 1000.0};   // [Hz]
constexpr base::Range kReachRange{0.0, 10.0};        // [m]
constexpr base::Range kPaddingRange{-100.0, 100.0};  // [m]
constexpr base::Range kScalingRange{-1e6, 1e6};      // [1/m]
constexpr base::Range kAmplitudeRange{0.0, 254.0};
constexpr double kMaxPersistence = 60;   // of scans [s]
constexpr int kMaxInflatedCells = 2000;  // in an inflation radius

void checkCostmapRange(double value, const base::Range& range, const std::string& where,
                       base::Diagnostics& problems) {
  if (!range.contains(value)) {
    problems.push_back(
        base::withContext(where, base::outOfRange(base::formatDouble(value), range)));
  }
}

void checkSource(const ObservationSource& source, const std::string& layer, double lidarHeight,
                 base::Diagnostics& problems) {
  checkCostmapRange(source.observationPersistence, {0.0, kMaxPersistence},
                    layer + "." + source.name + ".observation_persistence", problems);
  if (lidarHeight < source.minObstacleHeight || lidarHeight > source.maxObstacleHeight) {
    problems.push_back(base::warning(
        "nav2.lidar-not-taken",
        {layer, source.name, lidarHeight, source.minObstacleHeight, source.maxObstacleHeight}));
  }
  if (source.dataType != "LaserScan") {
    problems.push_back(base::warning("nav2.data-type", {layer, source.name, source.dataType}));
  }
}

/// `inscribed`: nullopt when the robot's footprint is invalid.
void checkInflation(const InflationLayerParameters& inflation, const std::string& layer,
                    const CostmapSetup& setup, std::optional<double> inscribed,
                    base::Diagnostics& problems) {
  const std::string key = layer + ".inflation_radius";
  checkCostmapRange(inflation.inflationRadius, kReachRange, key, problems);
  checkCostmapRange(inflation.costScalingFactor, kScalingRange, layer + ".cost_scaling_factor",
                    problems);
  if (!kReachRange.contains(inflation.inflationRadius)) {
    return;
  }
  const double side = setup.map.isEmpty() ? 0.0 : setup.map.resolution();
  if (inflation.inflationRadius > kMaxInflatedCells * side && side > 0.0) {
    problems.push_back(base::withContext(
        key, base::error("nav2.too-many-cells",
                         {inflation.inflationRadius, side, "the map", kMaxInflatedCells})));
  }
  if (inflation.enabled && inscribed && inflation.inflationRadius < *inscribed) {
    const double shown = std::round(1e4 * *inscribed) / 1e4;  // [m], rounded to 0.1 mm
    problems.push_back(base::withContext(
        key, base::warning("nav2.inflation-cut", {inflation.inflationRadius, shown})));
  }
}

void checkVoxelSource(const SpatioTemporalVoxelSource& source, const std::string& layer,
                      base::Diagnostics& problems) {
  const std::string prefix = layer + "." + source.name + ".";
  checkCostmapRange(source.observationPersistence, {0.0, kMaxPersistence},
                    prefix + "observation_persistence", problems);
  checkCostmapRange(source.decayAcceleration, {0.0, 1e6}, prefix + "decay_acceleration", problems);
}

/// Checks range sensor and spatio-temporal voxel layers.
void checkRangeAndVoxelLayers(const CostmapPlugin& plugin, double lidarHeight,
                              base::Diagnostics& problems) {
  const std::string prefix = plugin.name + ".";
  if (const auto* const range = std::get_if<RangeSensorLayerParameters>(&plugin.parameters)) {
    checkCostmapRange(range->phi, kReachRange, prefix + "phi", problems);
    checkCostmapRange(range->inflateCone, {0.0, 1.0}, prefix + "inflate_cone", problems);
    checkCostmapRange(range->clearThreshold, {0.0, 1.0}, prefix + "clear_threshold", problems);
    checkCostmapRange(range->markThreshold, {0.0, 1.0}, prefix + "mark_threshold", problems);
    if (range->enabled && range->topics.empty()) {
      problems.push_back(base::warning("nav2.no-source", {plugin.name}));
    }
    if (range->enabled && range->inputSensorType == "FIXED") {
      problems.push_back(base::warning("nav2.range-type", {plugin.name}));
    }
  }
  if (const auto* const decay =
          std::get_if<SpatioTemporalVoxelLayerParameters>(&plugin.parameters)) {
    checkCostmapRange(decay->voxelSize, kSideRange, prefix + "voxel_size", problems);
    if (decay->enabled && decay->sources.empty()) {
      problems.push_back(base::warning("nav2.no-source", {plugin.name}));
    }
    for (const SpatioTemporalVoxelSource& source : decay->sources) {
      checkVoxelSource(source, plugin.name, problems);
      const bool isSeen =
          lidarHeight >= source.minObstacleHeight && lidarHeight <= source.maxObstacleHeight;
      if (decay->enabled && source.enabled && source.marking && !isSeen) {
        problems.push_back(base::warning("nav2.lidar-not-taken",
                                         {plugin.name, source.name, lidarHeight,
                                          source.minObstacleHeight, source.maxObstacleHeight}));
      }
    }
  }
}

/// The inflation parameters of an inflation layer of any kind.
std::optional<InflationLayerParameters> inflationOf(const LayerParameters& parameters) {
  if (const auto* const plain = std::get_if<InflationLayerParameters>(&parameters)) {
    return *plain;
  }
  if (const auto* const legacy = std::get_if<LegacyInflationLayerParameters>(&parameters)) {
    return *legacy;
  }
  if (const auto* const asymmetric = std::get_if<AsymmetricInflationLayerParameters>(&parameters)) {
    InflationLayerParameters plain;
    plain.enabled = asymmetric->enabled;
    plain.inflationRadius = asymmetric->inflationRadius;
    plain.costScalingFactor =
        std::max(asymmetric->costScalingFactorLeft, asymmetric->costScalingFactorRight);
    return plain;
  }
  return std::nullopt;
}

void checkPlugin(const CostmapPlugin& plugin, const CostmapSetup& setup,
                 std::optional<double> inscribed, base::Diagnostics& problems) {
  const ObstacleLayerParameters* obstacles =
      std::get_if<ObstacleLayerParameters>(&plugin.parameters);
  if (const auto* const voxels = std::get_if<VoxelLayerParameters>(&plugin.parameters)) {
    obstacles = voxels;
  }
  if (obstacles != nullptr && obstacles->enabled) {
    if (obstacles->sources.empty()) {
      problems.push_back(base::warning("nav2.no-source", {plugin.name}));
    }
    for (const ObservationSource& source : obstacles->sources) {
      checkSource(source, plugin.name, setup.lidarHeight, problems);
    }
  }
  if (const auto inflation = inflationOf(plugin.parameters)) {
    checkInflation(*inflation, plugin.name, setup, inscribed, problems);
  }
  checkRangeAndVoxelLayers(plugin, setup.lidarHeight, problems);
  if (const auto* const container =
          std::get_if<PluginContainerLayerParameters>(&plugin.parameters)) {
    for (const CostmapPlugin& inner : container->layers) {
      checkPlugin(inner, setup, inscribed, problems);
    }
  }
  if (std::holds_alternative<StaticLayerParameters>(plugin.parameters) && setup.map.isEmpty()) {
    problems.push_back(base::warning("nav2.no-map", {plugin.name}));
  }
  if (const auto* const social = std::get_if<SocialLayerParameters>(&plugin.parameters)) {
    checkCostmapRange(social->amplitude, kAmplitudeRange, plugin.name + ".amplitude", problems);
    checkCostmapRange(social->sigmaPerSpeed, kReachRange, plugin.name + ".sigma_per_speed",
                      problems);
    checkCostmapRange(social->sigmaMin, {1e-3, 100.0}, plugin.name + ".sigma_min", problems);
    checkCostmapRange(social->sideRatio, {1e-3, 100.0}, plugin.name + ".side_ratio", problems);
    checkCostmapRange(social->rearRatio, {1e-3, 100.0}, plugin.name + ".rear_ratio", problems);
    checkCostmapRange(social->cutoff, {1.0, 254.0}, plugin.name + ".cutoff", problems);
  }
}

/// The cell size is compared only with a valid costmap size.
void checkSize(const CostmapParameters& parameters, base::Diagnostics& problems) {
  checkCostmapRange(parameters.width, kLengthRange, "width", problems);
  checkCostmapRange(parameters.height, kLengthRange, "height", problems);
  checkCostmapRange(parameters.resolution, kSideRange, "resolution", problems);
  if (!kSideRange.contains(parameters.resolution)) {
    return;
  }
  for (const auto& [key, length] :
       {std::pair<const char*, double>("width", parameters.width), {"height", parameters.height}}) {
    if (kLengthRange.contains(length) && length / parameters.resolution > kMaxCells) {
      problems.push_back(base::withContext(
          key, base::error("nav2.too-many-cells",
                           {length, parameters.resolution, "resolution", kMaxCells})));
    }
  }
  const bool isWide = parameters.width > parameters.height;
  const double shorter = isWide ? parameters.height : parameters.width;
  if (kLengthRange.contains(shorter) && shorter < parameters.resolution) {
    problems.push_back(base::withContext(
        "resolution", base::error("nav2.cell-too-large",
                                  {parameters.resolution, isWide ? "height" : "width", shorter})));
  }
}

/// The inscribed radius of the robot; nullopt when its keys are invalid.
std::optional<double> checkedInscribedRadius(const CostmapParameters& parameters,
                                             base::Diagnostics& problems) {
  const std::size_t before = problems.size();
  checkCostmapRange(parameters.footprintPadding, kPaddingRange, "footprint_padding", problems);
  const bool hasFootprint = !parameters.footprint.empty() && parameters.footprint != "[]";
  Polygon corners;
  if (hasFootprint) {
    const base::Result<Polygon> read = readPolygon(parameters.footprint);
    for (const base::Diagnostic& problem : read.diagnostics()) {
      problems.push_back(base::withContext("footprint", problem));
    }
    corners = read ? *read : corners;
  } else {
    checkCostmapRange(parameters.robotRadius, kReachRange, "robot_radius", problems);
  }
  if (problems.size() > before) {
    return std::nullopt;
  }
  return costmapFootprint(parameters.robotRadius, corners, parameters.footprintPadding).inscribed;
}

}  // namespace

base::Diagnostics problemsOf(const CostmapSetup& setup) {
  base::Diagnostics problems;
  const CostmapParameters& parameters = setup.settings.parameters;
  checkCostmapRange(parameters.updateFrequency, kFrequencyRange, "update_frequency", problems);
  checkCostmapRange(parameters.publishFrequency, kPublishRange, "publish_frequency", problems);
  if (parameters.updateFrequency == 0.0) {
    problems.push_back(base::withContext("update_frequency", base::warning("nav2.never-updated")));
  }
  checkSize(parameters, problems);
  checkCostmapRange(parameters.originX, kPlaceRange, "origin_x", problems);
  checkCostmapRange(parameters.originY, kPlaceRange, "origin_y", problems);
  const std::optional<double> inscribed = checkedInscribedRadius(parameters, problems);
  for (const CostmapPlugin& plugin : setup.settings.plugins) {
    checkPlugin(plugin, setup, inscribed, problems);
  }
  for (const CostmapPlugin& filter : setup.settings.filters) {
    checkPlugin(filter, setup, inscribed, problems);
    if (setup.masks.count(filter.name) == 0) {
      problems.push_back(base::warning("nav2.no-mask", {filter.name}));
    }
  }
  return problems;
}

}  // namespace sim2d::nav2
