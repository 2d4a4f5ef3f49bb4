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
#include "sim2d/nav/nav2/costmap/Footprint.h"
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

const std::vector<Nav2Key<LegacyInflationLayerParameters>>& keysOf(
    const LegacyInflationLayerParameters&) {
  return legacyInflationLayerKeys();
}
const std::vector<Nav2Key<AsymmetricInflationLayerParameters>>& keysOf(
    const AsymmetricInflationLayerParameters&) {
  return asymmetricInflationLayerKeys();
}
const std::vector<Nav2Key<DenoiseLayerParameters>>& keysOf(const DenoiseLayerParameters&) {
  return denoiseLayerKeys();
}
const std::vector<Nav2Key<RangeSensorLayerParameters>>& keysOf(const RangeSensorLayerParameters&) {
  return rangeSensorLayerKeys();
}
const std::vector<Nav2Key<DecayLayerParameters>>& keysOf(const DecayLayerParameters&) {
  return decayLayerKeys();
}
const std::vector<Nav2Key<ContainerLayerParameters>>& keysOf(const ContainerLayerParameters&) {
  return containerLayerKeys();
}
const std::vector<Nav2Key<BinaryFilterParameters>>& keysOf(const BinaryFilterParameters&) {
  return binaryFilterKeys();
}

/// Names in a text, with blanks between them, each once.
std::vector<std::string> sourceNames(NodeReader& node, const std::string& prefix,
                                     const std::string& text) {
  std::istringstream words(text);
  std::vector<std::string> names;
  for (std::string name; words >> name;) {
    names.push_back(name);
  }
  return pluginNames(node, prefix + "observation_sources", names);
}

void readSources(NodeReader& node, const std::string& prefix, ObstacleLayerParameters& layer) {
  for (const std::string& name : sourceNames(node, prefix, layer.observationSources)) {
    ObservationSource source;
    source.name = name;
    source.topic = name;
    layer.sources.push_back(
        node.read(prefix + name + ".", observationSourceKeys(), idleSourceKeys(), source));
    layer.sources.back().name = name;
  }
}

void readSources(NodeReader& node, const std::string& prefix, DecayLayerParameters& layer) {
  for (const std::string& name : sourceNames(node, prefix, layer.observationSources)) {
    DecaySource source;
    source.topic = name;
    layer.sources.push_back(
        node.read(prefix + name + ".", decaySourceKeys(), idleDecaySourceKeys(), source));
    layer.sources.back().name = name;
  }
}

/// Launch files of Nav2 switch filters on by replacing such words; they are off without.
bool isPlaceholder(const NodeReader& node, const std::string& name) {
  const GivenParameter* const plugin = node.parameters().find(name + ".plugin");
  return plugin != nullptr && plugin->value->text.find("Filter") != std::string::npos &&
         node.isPlaceholder(name + ".enabled");
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
constexpr const char* kObstacleLayer = "nav2_costmap_2d::ObstacleLayer";
constexpr std::array<LayerSubstitute, 3> kSubstitutes = {
    {{"nonpersistent_voxel_layer::NonPersistentVoxelLayer", kObstacleLayer,
      "its marks stay until a ray clears them"},
     {"nav2_costmap_2d::NonPersistentVoxelLayer", kObstacleLayer,
      "its marks stay until a ray clears them"},
     {"nav2_costmap_2d::ZoneParameterFilter", nullptr, "parameters of nodes do not change"}}};

const LayerSubstitute* substituteOf(const std::string& type) {
  const auto* const found =
      std::find_if(kSubstitutes.begin(), kSubstitutes.end(),
                   [&](const LayerSubstitute& each) { return type == each.type; });
  return found == kSubstitutes.end() ? nullptr : found;
}

void readLayer(NodeReader& node, const std::string& name, std::vector<CostmapPlugin>& to);

void readContained(NodeReader& node, const std::string& name, ContainerLayerParameters& container) {
  const std::string prefix = name + ".";
  for (const std::string& inner : pluginNames(node, prefix + "plugins", container.plugins)) {
    readLayer(node, prefix + inner, container.layers);
  }
}

/// What a layer consists of: sources, other layers.
template <class Layer>
void readParts(NodeReader& node, const std::string& name, Layer& layer) {
  if constexpr (std::is_base_of_v<ObstacleLayerParameters, Layer>) {
    readSources(node, name + ".", layer);
  } else if constexpr (std::is_same_v<DecayLayerParameters, Layer>) {
    readSources(node, name + ".", layer);
    for (const IdleKey& key : idleDecayKeys()) {
      node.know(name + "." + key.name, key.why);
    }
  } else if constexpr (std::is_same_v<ContainerLayerParameters, Layer>) {
    readContained(node, name, layer);
  }
}

/// Packages also hold layers of forks, so that the package alone is no evidence.
bool isMisspeltLayer(const std::string& type) {
  const std::vector<std::string> known = layerTypes();
  return isMisspelt(type, known) && base::nearestName(type, known).has_value();
}

/// A class of another package has no effect, unless its name is misspelt.
void readMissing(NodeReader& node, const std::string& name, const std::string& type) {
  const LayerSubstitute* const known = substituteOf(pluginName(type));
  if (known != nullptr) {
    tellLeftOut(node, name, type, known->why);
  } else if (isMisspeltLayer(pluginName(type))) {
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
        readParts(node, name, held);
      },
      *layer);
  if (isReplaced) {
    tellSubstitute(node, name, type, known->substitute, known->why);
    node.know(prefix, "a key of " + type);
  }
  to.push_back({name, *std::move(layer)});
}

/// One that cannot be read is no error of Nav2, which takes the radius then.
void checkFootprint(NodeReader& node, CostmapParameters& parameters) {
  const bool isGiven = !parameters.footprint.empty() && parameters.footprint != "[]";
  const base::Result<Polygon> corners = readPolygon(isGiven ? parameters.footprint : "");
  if (isGiven && !corners) {
    node.tell("footprint",
              base::within(node.node(), base::warning("nav2.footprint-invalid",
                                                      {corners.diagnostics().front().message})));
    parameters.footprint.clear();
  }
}

}  // namespace

CostmapSettings readCostmap(NodeReader& node) {
  CostmapSettings settings;
  settings.parameters = node.read({}, costmapKeys(), idleCostmapKeys(), CostmapParameters());
  checkFootprint(node, settings.parameters);
  for (const std::string& name : pluginNames(node, "plugins", settings.parameters.plugins)) {
    readLayer(node, name, settings.plugins);
  }
  for (const std::string& name : pluginNames(node, "filters", settings.parameters.filters)) {
    readLayer(node, name, settings.filters);
  }
  return settings;
}

}  // namespace sim2d::nav2
