#include "sim2d/nav/nav2/params/CostmapReading.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/PluginBlocks.h"

namespace sim2d::nav2 {
namespace {

const std::vector<Nav2Key<StaticLayerParameters>>& keysOf(const StaticLayerParameters&) {
  return staticLayerKeys();
}
const std::vector<Nav2Key<ObstacleLayerParameters>>& keysOf(const ObstacleLayerParameters&) {
  return obstacleLayerKeys();
}
const std::vector<Nav2Key<VoxelLayerParameters>>& keysOf(const VoxelLayerParameters&) {
  return voxelLayerKeys();
}
const std::vector<Nav2Key<InflationLayerParameters>>& keysOf(const InflationLayerParameters&) {
  return inflationLayerKeys();
}
const std::vector<Nav2Key<SocialLayerParameters>>& keysOf(const SocialLayerParameters&) {
  return socialLayerKeys();
}
const std::vector<Nav2Key<KeepoutFilterParameters>>& keysOf(const KeepoutFilterParameters&) {
  return keepoutFilterKeys();
}
const std::vector<Nav2Key<SpeedFilterParameters>>& keysOf(const SpeedFilterParameters&) {
  return speedFilterKeys();
}

void readSources(NodeReader& node, const std::string& prefix, ObstacleLayerParameters& layer) {
  std::istringstream words(layer.observationSources);
  std::vector<std::string> names;
  for (std::string name; words >> name;) {
    names.push_back(name);
  }
  for (const std::string& name : pluginNames(node, prefix + "observation_sources", names)) {
    ObservationSource source;
    source.name = name;
    source.topic = name;
    layer.sources.push_back(
        node.read(prefix + name + ".", observationSourceKeys(), idleSourceKeys(), source));
    layer.sources.back().name = name;
  }
}

/// Launch files of Nav2 put true or false in the place of such words.
bool isPlaceholder(const NodeReader& node, const std::string& name) {
  const GivenParameter* const enabled = node.parameters().find(name + ".enabled");
  return enabled != nullptr && enabled->value->isScalar() &&
         enabled->value->text.find("_ENABLED") != std::string::npos;
}

bool isSwitchedOff(NodeReader& node, const std::string& name) {
  if (isPlaceholder(node, name)) {
    node.tell(name + ".enabled", base::warning("nav2.launch-word", {name}));
    return true;
  }
  const Nav2Block block = node.given(name + ".");
  const auto found = block.find("enabled");
  const bool* const value = found == block.end() ? nullptr : std::get_if<bool>(&found->second);
  return value != nullptr && !*value;
}

/// Nav2 has these three when no plugins are named.
std::string usualClass(const NodeReader& node, const std::string& name) {
  static constexpr std::array<std::pair<const char*, const char*>, 3> kUsual = {
      {{"static_layer", "nav2_costmap_2d::StaticLayer"},
       {"obstacle_layer", "nav2_costmap_2d::ObstacleLayer"},
       {"inflation_layer", "nav2_costmap_2d::InflationLayer"}}};
  for (const auto& [layer, type] : kUsual) {
    if (name == layer && !node.has("plugins")) {
      return type;
    }
  }
  return {};
}

/// A layer that is not re-implemented; without a substitute it is left out.
struct LayerSubstitute {
  const char* type;
  const char* substitute;
  const char* why;
};
constexpr const char* kVoxelLayer = "nav2_costmap_2d::VoxelLayer";
constexpr const char* kInflationLayer = "nav2_costmap_2d::InflationLayer";
constexpr const char* kContainer = "nav2_costmap_2d::PluginContainerLayer";
constexpr std::array<LayerSubstitute, 7> kSubstitutes = {
    {{"spatio_temporal_voxel_layer::SpatioTemporalVoxelLayer", kVoxelLayer,
      "voxels are cleared by rays, they do not decay"},
     {"nav2_costmap_2d::LegacyInflationLayer", kInflationLayer, "costs are the same"},
     {"nav2_costmap_2d::AsymmetricInflationLayer", kInflationLayer,
      "both sides of a path are inflated with the mean of the two factors"},
     {"nav2_costmap_2d::DenoiseLayer", nullptr, "scans have no lone points to remove"},
     {"nav2_costmap_2d::RangeSensorLayer", nullptr, "robots have no range sensors"},
     {"nav2_costmap_2d::BinaryFilter", nullptr, "it publishes a state and no costs"},
     {"nav2_costmap_2d::ZoneParameterFilter", nullptr, "parameters of nodes do not change"}}};

const LayerSubstitute* substituteOf(const std::string& type) {
  const auto* const found =
      std::find_if(kSubstitutes.begin(), kSubstitutes.end(),
                   [&](const LayerSubstitute& each) { return type == each.type; });
  return found == kSubstitutes.end() ? nullptr : found;
}

/// A number that is given below a layer.
std::optional<double> numberAt(const NodeReader& node, const std::string& prefix,
                               const std::string& key) {
  const Nav2Block block = node.given(prefix);
  const auto found = block.find(key);
  const double* const value = found == block.end() ? nullptr : std::get_if<double>(&found->second);
  return value != nullptr ? std::optional<double>(*value) : std::nullopt;
}

/// Settings that a substitute needs and that its table does not contain.
void adapt(NodeReader& node, const std::string& prefix, LayerParameters& layer) {
  if (auto* const voxels = std::get_if<VoxelLayerParameters>(&layer)) {
    voxels->markThreshold = 0;  // counts voxels, which do not exist here
    for (ObservationSource& source : voxels->sources) {
      const auto range = numberAt(node, prefix + source.name + ".", "obstacle_range");
      source.obstacleMaxRange = range.value_or(source.obstacleMaxRange);
      source.raytraceMaxRange = range.value_or(source.raytraceMaxRange);
    }
  }
  if (auto* const inflation = std::get_if<InflationLayerParameters>(&layer)) {
    const auto left = numberAt(node, prefix, "cost_scaling_factor_left");
    const auto right = numberAt(node, prefix, "cost_scaling_factor_right");
    if (left || right) {
      constexpr double kUsual = 4.0;  // of the asymmetric layer
      inflation->costScalingFactor = 0.5 * (left.value_or(kUsual) + right.value_or(kUsual));
    }
  }
}

void readLayer(NodeReader& node, const std::string& name, std::vector<CostmapPlugin>& to);

/// Its plugins are merged into the costmap one by one.
void readContainer(NodeReader& node, const std::string& name, std::vector<CostmapPlugin>& to) {
  const auto names = node.value<std::vector<std::string>>(name + ".plugins");
  tellSubstitute(node, name, kContainer, "its plugins",
                 "they are merged into the costmap one by one");
  for (const std::string& inner :
       pluginNames(node, name + ".plugins", names.value_or(std::vector<std::string>()))) {
    readLayer(node, name + "." + inner, to);
  }
  node.know(name + ".enabled", "it is switched on");
  node.know(name + ".combination_method", "its plugins have their own");
}

/// A class of another package has no effect, unless its name is misspelt.
void readMissing(NodeReader& node, const std::string& name, const std::string& type) {
  const LayerSubstitute* const known = substituteOf(pluginName(type));
  if (known != nullptr) {
    tellLeftOut(node, name, type, known->why);
  } else if (base::nearestName(pluginName(type), layerTypes())) {
    tellUnknownPlugin(node, name, type, layerTypes());
  } else {
    tellLeftOut(node, name, type, "there is no class of this name here");
  }
}

void readLayer(NodeReader& node, const std::string& name, std::vector<CostmapPlugin>& to) {
  const std::string type = pluginClass(node, name, usualClass(node, name));
  const bool isOff = isSwitchedOff(node, name);
  const LayerSubstitute* const known = substituteOf(pluginName(type));
  const bool isReplaced = known != nullptr && known->substitute != nullptr;
  std::optional<LayerParameters> layer =
      layerOfType(isReplaced ? known->substitute : pluginName(type));
  if (pluginName(type) == kContainer && !isOff) {
    readContainer(node, name, to);
    return;
  }
  if (!layer || isPlaceholder(node, name)) {
    if (!isOff && !type.empty()) {
      readMissing(node, name, type);
    }
    node.know(name + ".", isOff ? "the layer is switched off" : "its class is not here");
    return;
  }
  const std::string prefix = name + ".";
  std::visit(
      [&](auto& held) {
        held = node.read(prefix, keysOf(held), idleLayerKeys(), held);
        if constexpr (std::is_base_of_v<ObstacleLayerParameters, std::decay_t<decltype(held)>>) {
          readSources(node, prefix, held);
        }
      },
      *layer);
  if (isReplaced) {
    tellSubstitute(node, name, type, known->substitute, known->why);
    adapt(node, prefix, *layer);
    node.know(prefix, "a key of " + type);
  }
  to.push_back({name, *std::move(layer)});
}

}  // namespace

CostmapSettings readCostmap(NodeReader& node) {
  CostmapSettings settings;
  settings.parameters = node.read({}, costmapKeys(), idleCostmapKeys(), CostmapParameters());
  for (const std::string& name : pluginNames(node, "plugins", settings.parameters.plugins)) {
    readLayer(node, name, settings.plugins);
  }
  for (const std::string& name : pluginNames(node, "filters", settings.parameters.filters)) {
    readLayer(node, name, settings.filters);
  }
  return settings;
}

}  // namespace sim2d::nav2
