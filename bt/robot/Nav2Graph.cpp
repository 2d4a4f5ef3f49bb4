#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>

#include "bt/robot/Nav2Files.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/NamedFiles.h"

// The graph of the route server.
namespace bt {
namespace {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else

/// Each operation of the graph names a plugin of the class TriggerEvent.
void checkOperations(const Nav2Parameters& parameters, Nav2Graph& to) {
  const auto check = [&](const std::vector<RouteOperation>& operations) {
    for (const RouteOperation& operation : operations) {
      const auto& loaded = parameters.route.operations;
      const bool isThere = std::any_of(loaded.begin(), loaded.end(), [&](const auto& each) {
        return each.first == operation.type &&
               std::holds_alternative<TriggerEventParameters>(each.second);
      });
      if (!isThere) {
        to.problems.push_back(base::warning("nav2.graph-operation", {operation.type}, to.file));
      }
    }
  };
  for (const RouteNode& node : to.graph.nodes) {
    check(node.operations);
  }
  for (const RouteEdge& edge : to.graph.edges) {
    check(edge.operations);
  }
}

}  // namespace

Nav2Graph loadNav2Graph(const Nav2Parameters& parameters) {
  Nav2Graph result;
  const std::string& named = parameters.route.server.graphFilepath;
  if (named.empty()) {
    return result;
  }
  const NamedFile found =
      findNamedFile(named, {std::filesystem::path(parameters.file).parent_path().string()});
  result.file = found.file;
  if (result.file.empty()) {
    result.problems.push_back(placedInFile(
        parameters, base::within("route_server", namedFileMissing("graph_filepath", named, found,
                                                                  "an empty graph"))));
    return result;
  }
  const base::Result<std::string> text = base::readTextFile(result.file);
  base::append(result.problems, text.diagnostics());
  if (!text) {
    return result;
  }
  base::Result<RouteGraph> graph = readRouteGraph(*text, result.file);
  base::append(result.problems, graph.diagnostics());
  if (graph) {
    result.graph = *std::move(graph);
    checkOperations(parameters, result);
  }
  return result;
}

}  // namespace bt
