#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"
#include "sim2d/nav/nav2/params/NodeReader.h"
#include "sim2d/nav/nav2/params/ServerParameterReader.h"

namespace sim2d::nav2 {
namespace {

/// Splits a text at blanks and removes duplicate names.
std::vector<std::string> sourceNames(NodeReader& node, const std::string& prefix,
                                     const std::string& text) {
  std::istringstream words(text);
  std::vector<std::string> names;
  for (std::string name; words >> name;) {
    names.push_back(name);
  }
  return uniquePluginNames(node, prefix + "observation_sources", names);
}

template <class Source, class Layer>
void readSources(NodeReader& node, const std::string& prefix,
                 const std::vector<Nav2Key<Source>>& keys, const std::vector<IgnoredKey>& ignored,
                 Layer& layer) {
  for (const std::string& name : sourceNames(node, prefix, layer.observationSources)) {
    Source source;
    source.topic = name;
    source = node.read(prefix + name + ".", keys, ignored, source);
    source.name = name;
    layer.sources.push_back(std::move(source));
  }
}

/// Nav2's launch files enable filters by replacing such placeholders; without them filters are off.
bool isPlaceholder(const NodeReader& node, const std::string& name) {
  const GivenParameter* const plugin = node.parameters().find(name + ".plugin");
  return plugin != nullptr && plugin->value->text.find("Filter") != std::string::npos &&
         node.isPlaceholder(name + ".enabled");
}

bool isSwitchedOff(NodeReader& node, const std::string& name) {
  if (isPlaceholder(node, name)) {
    node.report(name + ".enabled", base::warning("nav2.launch-word", {name}));
    return true;
  }
  const Nav2ParameterBlock block = node.given(name + ".");
  const auto found = block.find("enabled");
  const bool* const value = found == block.end() ? nullptr : std::get_if<bool>(&found->second);
  return value != nullptr && !*value;
}

/// Nav2 loads these three layers when `plugins` is absent.
constexpr std::array<DefaultPlugin, 3> kDefaultLayers = {
    {{"static_layer", "nav2_costmap_2d::StaticLayer"},
     {"obstacle_layer", "nav2_costmap_2d::ObstacleLayer"},
     {"inflation_layer", "nav2_costmap_2d::InflationLayer"}}};

/// A layer that is not re-implemented; null `substitute`: the layer is left out.
struct LayerSubstitute {
  const char* type;
  const char* substitute;
  const char* why;
};
constexpr const char* kObstacleLayer = "nav2_costmap_2d::ObstacleLayer";
constexpr std::array<LayerSubstitute, 3> kSubstitutes = {
    {{"nonpersistent_voxel_layer::NonPersistentVoxelLayer", kObstacleLayer,
      "its marked cells stay until a ray clears them"},
     {"nav2_costmap_2d::NonPersistentVoxelLayer", kObstacleLayer,
      "its marked cells stay until a ray clears them"},
     {"nav2_costmap_2d::ZoneParameterFilter", nullptr, "parameters of nodes are constant"}}};

const LayerSubstitute* substituteOf(const std::string& type) {
  return base::findBy(kSubstitutes, &LayerSubstitute::type, type);
}

void readLayer(NodeReader& node, const std::string& name, std::vector<CostmapPlugin>& to);

void readContained(NodeReader& node, const std::string& name,
                   PluginContainerLayerParameters& container) {
  const std::string prefix = name + ".";
  for (const std::string& inner : uniquePluginNames(node, prefix + "plugins", container.plugins)) {
    readLayer(node, prefix + inner, container.layers);
  }
}

/// Reads the parts of a layer: observation sources, nested layers.
template <class Layer>
void readParts(NodeReader& node, const std::string& name, Layer& layer) {
  if constexpr (std::is_base_of_v<ObstacleLayerParameters, Layer>) {
    readSources(node, name + ".", observationSourceKeys(), ignoredSourceKeys(), layer);
  } else if constexpr (std::is_same_v<SpatioTemporalVoxelLayerParameters, Layer>) {
    readSources(node, name + ".", spatioTemporalVoxelSourceKeys(),
                ignoredSpatioTemporalVoxelSourceKeys(), layer);
    for (const IgnoredKey& key : ignoredSpatioTemporalVoxelKeys()) {
      node.markIgnored(name + "." + key.name, key.why);
    }
  } else if constexpr (std::is_same_v<PluginContainerLayerParameters, Layer>) {
    readContained(node, name, layer);
  }
}

/// Packages also contain layers of forks, so the package alone is no evidence of a misspelling.
bool isMisspeltLayer(const std::string& type) {
  const std::vector<std::string> known = layerTypes();
  return isMisspelt(type, known) && base::nearestName(type, known).has_value();
}

/// A class of another package has no effect; a misspelt name is an error.
void reportMissingLayer(NodeReader& node, const std::string& name, const std::string& type) {
  const LayerSubstitute* const known = substituteOf(normalizedPluginClass(type));
  if (known != nullptr) {
    reportOmittedPlugin(node, name, type, known->why);
  } else if (isMisspeltLayer(normalizedPluginClass(type))) {
    reportUnknownPlugin(node, name, type, layerTypes());
  } else {
    reportOmittedPlugin(node, name, type, "no class of this name is implemented");
  }
}

void readLayer(NodeReader& node, const std::string& name, std::vector<CostmapPlugin>& to) {
  const std::string type =
      pluginClass(node, name, defaultClass(node, "plugins", name, kDefaultLayers));
  const bool isOff = isSwitchedOff(node, name);
  const LayerSubstitute* const known = substituteOf(normalizedPluginClass(type));
  const bool isReplaced = known != nullptr && known->substitute != nullptr;
  std::optional<LayerParameters> layer =
      layerOfType(isReplaced ? known->substitute : normalizedPluginClass(type));
  if (!layer || isPlaceholder(node, name)) {
    if (!isOff && !type.empty()) {
      reportMissingLayer(node, name, type);
    }
    node.markIgnored(name + ".", isOff ? "the layer is disabled" : "its class is not implemented");
    return;
  }
  const std::string prefix = name + ".";
  std::visit(
      [&](auto& held) {
        held = node.read(prefix, keysOf(held), ignoredLayerKeys(), held);
        readParts(node, name, held);
      },
      *layer);
  if (isReplaced) {
    reportSubstitute(node, name, type, known->substitute, known->why);
    node.markIgnored(prefix, "a key of " + type);
  }
  to.push_back({name, *std::move(layer)});
}

/// Nav2 accepts an invalid footprint and uses `robot_radius` instead.
void checkFootprint(NodeReader& node, CostmapParameters& parameters) {
  const bool isGiven = !parameters.footprint.empty() && parameters.footprint != "[]";
  const base::Result<Polygon> corners = readPolygon(isGiven ? parameters.footprint : "");
  if (isGiven && !corners) {
    node.report(
        "footprint",
        base::withContext(node.node(), base::warning("nav2.footprint-invalid",
                                                     {corners.diagnostics().front().message})));
    parameters.footprint.clear();
  }
}

}  // namespace

CostmapSettings readCostmap(NodeReader& node) {
  CostmapSettings settings;
  settings.parameters = node.read({}, costmapKeys(), ignoredCostmapKeys(), CostmapParameters());
  checkFootprint(node, settings.parameters);
  for (const std::string& name : uniquePluginNames(node, "plugins", settings.parameters.plugins)) {
    readLayer(node, name, settings.plugins);
  }
  for (const std::string& name : uniquePluginNames(node, "filters", settings.parameters.filters)) {
    readLayer(node, name, settings.filters);
  }
  return settings;
}

}  // namespace sim2d::nav2
