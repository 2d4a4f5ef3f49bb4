#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/route/RouteGraph.h"
#include "sim2d/nav/nav2/route/RouteParameters.h"

namespace sim2d::nav2 {

/// State of DynamicEdgesScorer, set by its service adjust_edges.
struct DynamicEdges {
  std::set<std::uint32_t> closed;         // edge ids
  std::map<std::uint32_t, double> costs;  // additional costs by edge id

  /// Parses "close 3 4", "open 3", "cost 3 2.5". Returns false without changes for other texts.
  bool apply(const std::string& text);
};

/// Inputs of the scorers.
struct ScoringScene {
  const RouteRequest& request;
  const DynamicEdges& dynamicEdges;
  const RouteScene& scene;  // edges are invalid without the costmap of a scorer
};

/// Plugins of the key edge_cost_functions by name (nav2_route, plugins/edge_cost_functions).
using EdgeScorers = std::vector<std::pair<std::string, EdgeScorerSettings>>;

struct RouteQuery {
  std::size_t start = 0, goal = 0;  // node indices
  int maxIterations = 0;            // expanded nodes; 0: unlimited
};

/// The cheapest route between two nodes (nav2_route::RoutePlanner): Dijkstra's search over directed
/// edges. The cost of an edge is determined by the scorers, or by the file if the edge is not
/// overridable or there is no scorer. Errors: NoValidRoute; NoValidGraph, an edge whose cost in the
/// file is used but not above 0; Timeout, more than `maxIterations` nodes; InvalidEdgeScorerUse, a
/// scorer of headings in a request by ids. Of equal costs the route found first is kept.
RouteResult findRoute(const RouteGraph& graph, const RouteQuery& query, const BlockedEdges& blocked,
                      const EdgeScorers& scorers, const ScoringScene& scene);

}  // namespace sim2d::nav2
