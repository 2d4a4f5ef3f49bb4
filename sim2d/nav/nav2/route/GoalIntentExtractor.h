#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/route/RouteGraph.h"
#include "sim2d/nav/nav2/route/RouteParameters.h"

/// Determines the start and goal nodes of a request (nav2_route::GoalIntentExtractor).
namespace sim2d::nav2 {

/// The edge that is being followed during rerouting.
struct ContinuedEdge {
  std::optional<std::size_t> edge;  // index
  Vec2 nearest = Vec2::Zero();      // its nearest point to the robot [m]
};

/// The nodes nearest to a position, nearest first; at equal distances in file order.
std::vector<std::size_t> nearestNodes(const RouteGraph& graph, const Vec2& place,
                                      std::size_t count);

/// The node of a pose: the nearest one if the straight line to it is free in the costmap (no cell
/// >= 253 except unknown ones); else, of the nearest `num_nearest_nodes`, the first one reached by
/// a search through free cells. The nearest one without a costmap, with `enable_nn_search` off, or
/// when the search reaches none. nullopt: the graph has no nodes.
std::optional<std::size_t> nodeOfPose(const RouteGraph& graph, const Vec2& place,
                                      const Costmap* costmap,
                                      const RouteServerParameters& parameters);

/// Removes the first edge if the start is beside it and past its first node, and the last one if
/// the goal is beside it and before its last node. `continued`: the edge being followed; kept if it
/// is the removed one, else reset. `isFirst`: the route is not a reroute.
Route pruneRoute(Route route, const RouteGraph& graph, const RouteRequest& request, bool isFirst,
                 const RouteServerParameters& parameters, ContinuedEdge& continued);

}  // namespace sim2d::nav2
