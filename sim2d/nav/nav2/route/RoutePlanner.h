#pragma once

#include "sim2d/nav/nav2/route/EdgeScorers.h"
#include "sim2d/nav/nav2/route/Route.h"

namespace sim2d::nav2 {

struct RouteQuery {
  std::size_t start = 0, goal = 0;  // nodes by index
  int maxIterations = 0;            // nodes that are expanded; 0: no limit
};

/// The cheapest route between two nodes (nav2_route::RoutePlanner): Dijkstra's search over directed
/// edges. The cost of an edge is what the scorers find, or that of the file when the edge is not
/// overridable or there is no scorer. Errors: NoValidRoute; NoValidGraph, an edge without a cost
/// above 0 where that of the file counts; Timeout, more than `maxIterations` nodes;
/// InvalidEdgeScorerUse, a scorer of headings in a request by ids. Of equal costs the way that was
/// found first stays.
RouteResult findRoute(const RouteGraph& graph, const RouteQuery& query, const BlockedEdges& blocked,
                      const EdgeScorers& scorers, const ScoringScene& scene);

}  // namespace sim2d::nav2
