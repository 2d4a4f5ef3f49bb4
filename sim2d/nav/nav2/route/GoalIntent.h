#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/route/Route.h"
#include "sim2d/nav/nav2/route/RouteParameters.h"

/// Between which nodes a request means to go (nav2_route::GoalIntentExtractor).
namespace sim2d::nav2 {

/// The edge that is being followed while a route is found anew.
struct ContinuedEdge {
  std::optional<std::size_t> edge;  // by index
  Vec2 nearest = Vec2::Zero();      // point of it that is nearest to the robot [m]
};

/// The nodes nearest to a pose, nearest first; of equal distances the first of the file.
std::vector<std::size_t> nearestNodes(const RouteGraph& graph, const Vec2& place,
                                      std::size_t count);

/// The node that a pose belongs to: the nearest one when the straight line to it is free in the
/// costmap (no cell from 253 on but unknown ones); else, of the nearest `num_nearest_nodes`, the
/// one that a search through free cells reaches first. Without a costmap, with `enable_nn_search`
/// off, or when the search reaches none, the nearest one. None: the graph has no nodes.
std::optional<std::size_t> nodeOfPose(const RouteGraph& graph, const Vec2& place,
                                      const Costmap* costmap,
                                      const RouteServerParameters& parameters);

/// Leaves out the first edge when the start lies beside it past its first node, and the last one
/// when the goal lies beside it before its last node. `continued`: the edge that is being followed;
/// it stays when it is the one that is left out, else it is reset. `isFirst`: the route is not
/// found anew.
Route pruned(Route route, const RouteGraph& graph, const RouteRequest& request, bool isFirst,
             const RouteServerParameters& parameters, ContinuedEdge& continued);

/// The point of a segment that is nearest to a place [m].
Vec2 nearestOn(const Vec2& from, const Vec2& to, const Vec2& place);

}  // namespace sim2d::nav2
