#pragma once

#include <optional>

#include "sim2d/nav/nav2/route/GoalIntent.h"

/// How far a robot has come on a route (nav2_route::RouteTracker).
namespace sim2d::nav2 {

struct TrackState {
  int edge = -1;                       // number in the route; -1: on the way to its start
  std::optional<std::size_t> current;  // edge by index; none: before the first, or after the last
  std::size_t nextNode = 0;            // node by index
  std::optional<std::size_t> lastNode;
  bool isNear = false;  // was within the radius of the next node
};

/// At the beginning of a route; with an edge that is continued, on that edge.
TrackState beginTracking(const Route& route, const RouteGraph& graph,
                         const ContinuedEdge& continued);

/// Whether the robot has achieved the next node. The first and the last node: it is within
/// `boundary_radius_to_achieve_node`. Nodes in between: it is within `radius_to_achieve_node` and
/// has crossed the line through the node that halves the angle between its edges, or it has left
/// that radius again.
bool achievesNode(TrackState& state, const Vec2& robot, const Route& route, const RouteGraph& graph,
                  const RouteServerParameters& parameters);

/// Goes on to the next edge. False: the node that was achieved is the last one.
bool goOn(TrackState& state, const Route& route, const RouteGraph& graph);

}  // namespace sim2d::nav2
