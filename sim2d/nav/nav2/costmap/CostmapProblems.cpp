#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"
#include "sim2d/nav/nav2/costmap/LayeredCostmap.h"

namespace sim2d::nav2 {
namespace {

constexpr double kLeastSide = 0.005;                       // of cells [m]
constexpr double kMostCells = 4000;                        // along one side
constexpr base::Range kLengthRange{1.0, 1000.0};           // of costmaps [m]
constexpr base::Range kFrequencyRange{0.0, 1000.0, true};  // [Hz]
constexpr base::Range kReachRange{0.0, 10.0};              // [m]
constexpr base::Range kAmplitudeRange{0.0, 254.0};
constexpr double kLongestPersistence = 60;   // of scans [s]
constexpr double kMostInflatedCells = 2000;  // of a radius

void checkCostmapRange(double value, const base::Range& range, const std::string& where,
                       base::Diagnostics& problems) {
  if (!range.contains(value)) {
    problems.push_back(base::within(where, base::outOfRange(base::formatDouble(value), range)));
  }
}

void checkSource(const ObservationSource& source, const std::string& layer, double lidarHeight,
                 base::Diagnostics& problems) {
  checkCostmapRange(source.observationPersistence, {0.0, kLongestPersistence},
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

void checkPlugin(const CostmapPlugin& plugin, const CostmapSetup& setup, double inscribed,
                 base::Diagnostics& problems) {
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
  if (const auto* const inflation = std::get_if<InflationLayerParameters>(&plugin.parameters)) {
    const double own = setup.settings.parameters.resolution;
    const double side = setup.map.isEmpty() ? own : std::min(own, setup.map.resolution());
    checkCostmapRange(inflation->inflationRadius,
                      {0.0, std::min(kReachRange.high, kMostInflatedCells * side)},
                      plugin.name + ".inflation_radius", problems);
    if (inflation->enabled && inflation->inflationRadius < inscribed) {
      const double shown = std::round(1e4 * inscribed) / 1e4;  // [m], to a tenth of a millimetre
      problems.push_back(
          base::warning("nav2.inflation-cut", {plugin.name, inflation->inflationRadius, shown}));
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

}  // namespace

base::Diagnostics problemsOf(const CostmapSetup& setup) {
  base::Diagnostics problems;
  const CostmapParameters& parameters = setup.settings.parameters;
  checkCostmapRange(parameters.updateFrequency, kFrequencyRange, "update_frequency", problems);
  checkCostmapRange(parameters.publishFrequency, {}, "publish_frequency", problems);
  const double longer = std::max(parameters.width, parameters.height);
  const double shorter = std::min(parameters.width, parameters.height);
  checkCostmapRange(parameters.resolution, {std::max(kLeastSide, longer / kMostCells), shorter},
                    "resolution", problems);
  checkCostmapRange(parameters.width, kLengthRange, "width", problems);
  checkCostmapRange(parameters.height, kLengthRange, "height", problems);
  checkCostmapRange(parameters.robotRadius, kReachRange, "robot_radius", problems);
  checkCostmapRange(parameters.footprintPadding, {-100.0, 100.0}, "footprint_padding", problems);
  Polygon corners;
  if (!parameters.footprint.empty() && parameters.footprint != "[]") {
    const base::Result<Polygon> read = readPolygon(parameters.footprint);
    base::append(problems, read.diagnostics());
    corners = read ? *read : corners;
  }
  const double inscribed =
      costmapFootprint(parameters.robotRadius, corners, parameters.footprintPadding).inscribed;
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
