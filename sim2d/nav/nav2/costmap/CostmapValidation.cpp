#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/Text.h"
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
constexpr double kMaxPersistence = 60.0;             // of scans [s]
constexpr base::Range kPersistenceRange{0.0, kMaxPersistence};
constexpr int kMaxInflatedCells = 2000;  // in an inflation radius

/// A value that must be in a range, and its key.
struct CheckedValue {
  double value;
  base::Range range;
  const char* key;
};

/// Adds an error for each value out of its range; `prefix` ("inflation_layer.") precedes the keys.
void checkRanges(const std::string& prefix, std::initializer_list<CheckedValue> values,
                 base::Diagnostics& problems) {
  for (const auto& [value, range, key] : values) {
    if (!range.contains(value)) {
      problems.push_back(
          base::withContext(prefix + key, base::outOfRange(base::formatDouble(value), range)));
    }
  }
}

/// Checks a plugin by the type of its parameters.
struct PluginCheck {
  const CostmapPlugin& plugin;
  const CostmapSetup& setup;
  std::optional<double> inscribed;  // nullopt when the robot's footprint is invalid
  base::Diagnostics& problems;

  void operator()(const ObstacleLayerParameters& layer) const {
    if (!layer.enabled) {
      return;
    }
    warnUnless(!layer.sources.empty(), "nav2.no-source");
    for (const ObservationSource& source : layer.sources) {
      ranges({{source.observationPersistence, kPersistenceRange, "observation_persistence"}},
             source.name + ".");
      checkHeights(source);
      if (source.dataType != "LaserScan") {
        problems.push_back(
            base::warning("nav2.data-type", {plugin.name, source.name, source.dataType}));
      }
    }
  }

  void operator()(const InflationLayerParameters& layer) const {
    ranges({{layer.inflationRadius, kReachRange, "inflation_radius"},
            {layer.costScalingFactor, kScalingRange, "cost_scaling_factor"}});
    if (!kReachRange.contains(layer.inflationRadius)) {
      return;
    }
    const std::string key = plugin.name + ".inflation_radius";
    const double side = setup.map.isEmpty() ? 0.0 : setup.map.resolution();
    if (layer.inflationRadius > kMaxInflatedCells * side && side > 0.0) {
      problems.push_back(base::withContext(
          key, base::error("nav2.too-many-cells",
                           {layer.inflationRadius, side, "the map", kMaxInflatedCells})));
    }
    if (layer.enabled && inscribed && layer.inflationRadius < *inscribed) {
      const double shown = std::round(1e4 * *inscribed) / 1e4;  // [m], rounded to 0.1 mm
      problems.push_back(base::withContext(
          key, base::warning("nav2.inflation-cut", {layer.inflationRadius, shown})));
    }
  }

  void operator()(const AsymmetricInflationLayerParameters& layer) const {
    InflationLayerParameters plain = static_cast<const InflationLayerParameters&>(layer);
    plain.costScalingFactor = std::max(layer.costScalingFactorLeft, layer.costScalingFactorRight);
    (*this)(plain);
  }

  void operator()(const RangeSensorLayerParameters& layer) const {
    ranges({{layer.phi, kReachRange, "phi"},
            {layer.inflateCone, {0.0, 1.0}, "inflate_cone"},
            {layer.clearThreshold, {0.0, 1.0}, "clear_threshold"},
            {layer.markThreshold, {0.0, 1.0}, "mark_threshold"}});
    warnUnless(!layer.enabled || !layer.topics.empty(), "nav2.no-source");
    warnUnless(!layer.enabled || layer.inputSensorType != "FIXED", "nav2.range-type");
  }

  void operator()(const SpatioTemporalVoxelLayerParameters& layer) const {
    ranges({{layer.voxelSize, kSideRange, "voxel_size"}});
    warnUnless(!layer.enabled || !layer.sources.empty(), "nav2.no-source");
    for (const SpatioTemporalVoxelSource& source : layer.sources) {
      ranges({{source.observationPersistence, kPersistenceRange, "observation_persistence"},
              {source.decayAcceleration, {0.0, 1e6}, "decay_acceleration"}},
             source.name + ".");
      if (layer.enabled && source.enabled && source.marking) {
        checkHeights(source);
      }
    }
  }

  void operator()(const PluginContainerLayerParameters& container) const {
    for (const CostmapPlugin& inner : container.layers) {
      std::visit(PluginCheck{inner, setup, inscribed, problems}, inner.parameters);
    }
  }
  void operator()(const StaticLayerParameters& /*layer*/) const {
    warnUnless(!setup.map.isEmpty(), "nav2.no-map");
  }

  void operator()(const SocialLayerParameters& layer) const {
    ranges({{layer.amplitude, {0.0, 254.0}, "amplitude"},
            {layer.sigmaPerSpeed, kReachRange, "sigma_per_speed"},
            {layer.sigmaMin, {1e-3, 100.0}, "sigma_min"},
            {layer.sideRatio, {1e-3, 100.0}, "side_ratio"},
            {layer.rearRatio, {1e-3, 100.0}, "rear_ratio"},
            {layer.cutoff, {1.0, 254.0}, "cutoff"}});
  }
  void operator()(const DenoiseLayerParameters& /*layer*/) const {}
  void operator()(const CostmapFilterParameters& /*filter*/) const {}

  void ranges(std::initializer_list<CheckedValue> values, const std::string& prefix = {}) const {
    checkRanges(plugin.name + "." + prefix, values, problems);
  }
  void warnUnless(bool isRight, const char* code) const {
    if (!isRight) {
      problems.push_back(base::warning(code, {plugin.name}));
    }
  }
  /// Warns if the lidar is outside the heights of a source.
  void checkHeights(const ObservationSource& source) const {
    const double height = setup.lidarHeight;
    if (height < source.minObstacleHeight || height > source.maxObstacleHeight) {
      problems.push_back(base::warning(
          "nav2.lidar-not-taken",
          {plugin.name, source.name, height, source.minObstacleHeight, source.maxObstacleHeight}));
    }
  }
};

/// The cell size is compared only with a valid costmap size.
void checkSize(const CostmapParameters& parameters, base::Diagnostics& problems) {
  checkRanges({},
              {{static_cast<double>(parameters.width), kLengthRange, "width"},
               {static_cast<double>(parameters.height), kLengthRange, "height"},
               {parameters.resolution, kSideRange, "resolution"}},
              problems);
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
  checkRanges({}, {{parameters.footprintPadding, kPaddingRange, "footprint_padding"}}, problems);
  const bool hasFootprint = !parameters.footprint.empty() && parameters.footprint != "[]";
  Polygon corners;
  if (hasFootprint) {
    const base::Result<Polygon> read = readPolygon(parameters.footprint);
    for (const base::Diagnostic& problem : read.diagnostics()) {
      problems.push_back(base::withContext("footprint", problem));
    }
    corners = read ? *read : corners;
  } else {
    checkRanges({}, {{parameters.robotRadius, kReachRange, "robot_radius"}}, problems);
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
  checkRanges({},
              {{parameters.updateFrequency, kFrequencyRange, "update_frequency"},
               {parameters.publishFrequency, kPublishRange, "publish_frequency"}},
              problems);
  if (parameters.updateFrequency == 0.0) {
    problems.push_back(base::withContext("update_frequency", base::warning("nav2.never-updated")));
  }
  checkSize(parameters, problems);
  checkRanges({},
              {{parameters.originX, kPlaceRange, "origin_x"},
               {parameters.originY, kPlaceRange, "origin_y"}},
              problems);
  const std::optional<double> inscribed = checkedInscribedRadius(parameters, problems);
  const auto check = [&](const CostmapPlugin& plugin) {
    std::visit(PluginCheck{plugin, setup, inscribed, problems}, plugin.parameters);
  };
  std::for_each(setup.settings.plugins.begin(), setup.settings.plugins.end(), check);
  for (const CostmapPlugin& filter : setup.settings.filters) {
    check(filter);
    if (setup.masks.count(filter.name) == 0) {
      problems.push_back(base::warning("nav2.no-mask", {filter.name}));
    }
  }
  return problems;
}

}  // namespace sim2d::nav2
