#include "sim2d/nav/nav2/params/CostmapReading.h"

#include <array>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>
#include <variant>

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

std::optional<CostmapPlugin> readLayer(NodeReader& node, const std::string& name) {
  const std::string type = pluginClass(node, name, usualClass(node, name));
  const bool isOff = isSwitchedOff(node, name);
  std::optional<LayerParameters> layer = layerOfType(pluginName(type));
  if (!layer || isPlaceholder(node, name)) {
    if (!isOff && !type.empty()) {
      tellUnknownPlugin(node, name, type, layerTypes());
    }
    node.know(name + ".", isOff ? "the layer is switched off" : "its class is not here");
    return std::nullopt;
  }
  std::visit(
      [&](auto& held) {
        held = node.read(name + ".", keysOf(held), idleLayerKeys(), held);
        if constexpr (std::is_base_of_v<ObstacleLayerParameters, std::decay_t<decltype(held)>>) {
          readSources(node, name + ".", held);
        }
      },
      *layer);
  return CostmapPlugin{name, *std::move(layer)};
}

}  // namespace

CostmapSettings readCostmap(NodeReader& node) {
  CostmapSettings settings;
  settings.parameters = node.read({}, costmapKeys(), idleCostmapKeys(), CostmapParameters());
  for (const std::string& name : pluginNames(node, "plugins", settings.parameters.plugins)) {
    if (auto plugin = readLayer(node, name)) {
      settings.plugins.push_back(*std::move(plugin));
    }
  }
  for (const std::string& name : pluginNames(node, "filters", settings.parameters.filters)) {
    if (auto plugin = readLayer(node, name)) {
      settings.filters.push_back(*std::move(plugin));
    }
  }
  return settings;
}

}  // namespace sim2d::nav2
