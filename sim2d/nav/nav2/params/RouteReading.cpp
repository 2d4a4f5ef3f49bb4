#include "sim2d/nav/nav2/params/RouteReading.h"

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim2d/nav/nav2/params/PluginBlocks.h"

namespace sim2d::nav2 {
namespace {

/// Keys of one plugin. Costs of classes have no fixed names: semantic_classes lists them.
template <class Parameters>
void readPlugin(NodeReader& node, const std::string& name, Parameters& parameters) {
  const std::string prefix = name + ".";
  parameters = node.read(prefix, keysOf(parameters), {}, parameters);
  if constexpr (std::is_same_v<Parameters, SemanticScorerParameters>) {
    for (const std::string& one : parameters.semanticClasses) {
      parameters.costs[one] = node.value<double>(prefix + one).value_or(0.0);
    }
  }
  if constexpr (std::is_same_v<Parameters, AdjustSpeedLimitParameters>) {
    node.know(prefix + "speed_limit_topic",
              "the limit is passed to the controller server directly");
  }
}

/// Without the list, Nav2 has the classes of the default names.
std::string usualClass(const NodeReader& node, const std::string& list, const std::string& name) {
  return node.has(list) ? std::string() : "nav2_route::" + name;
}

template <class Settings, class Find>
void readPlugins(NodeReader& node, const std::string& list, const std::vector<std::string>& names,
                 const Find& find, const std::vector<std::string>& known,
                 std::vector<std::pair<std::string, Settings>>& to) {
  for (const std::string& name : pluginNames(node, list, names)) {
    const std::string plugin = pluginClass(node, name, usualClass(node, list, name));
    if (plugin.empty()) {
      continue;
    }
    std::optional<Settings> settings = find(plugin);
    if (!settings) {
      tellUnknownPlugin(node, name, plugin, known);
      node.know(name + ".", "its class is not here");
      continue;
    }
    std::visit([&](auto& parameters) { readPlugin(node, name, parameters); }, *settings);
    to.emplace_back(name, *std::move(settings));
  }
}

}  // namespace

RouteSettings readRouteServer(NodeReader node) {
  RouteSettings route;
  route.server = node.read({}, routeServerKeys(), idleRouteServerKeys(), route.server);
  tellAt(node, problemsOf(route.server));
  readPlugins(node, "edge_cost_functions", route.server.edgeCostFunctions, edgeScorerOf,
              edgeScorerPlugins(), route.scorers);
  readPlugins(node, "operations", route.server.operations, routeOperationOf,
              routeOperationPlugins(), route.operations);
  node.finish();
  return route;
}

}  // namespace sim2d::nav2
