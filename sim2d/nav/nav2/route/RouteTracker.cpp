#include "sim2d/nav/nav2/route/RouteTracker.h"

namespace sim2d::nav2 {
namespace {

bool isBoundary(const TrackState& state, const Route& route) {
  return state.edge == -1 || state.edge == static_cast<int>(route.edges.size()) - 1;
}

/// Whether a place lies past the node, by the directions of the edges before and after it.
bool isPast(const Vec2& before, const Vec2& node, const Vec2& after, const Vec2& place) {
  constexpr double kLeast = 1e-6;  // [m]
  const Vec2 in = node - before, out = after - node;
  if (in.norm() < kLeast || out.norm() < kLeast) {
    return true;
  }
  return (in.normalized() + out.normalized()).dot(node - place) <= 0.0;
}

}  // namespace

TrackState beginTracking(const Route& route, const RouteGraph& graph,
                         const ContinuedEdge& continued) {
  TrackState state;
  state.nextNode = route.start;
  if (continued.edge) {
    state.current = continued.edge;
    state.lastNode = graph.edges[*continued.edge].from;
  }
  return state;
}

bool achievesNode(TrackState& state, const Vec2& robot, const Route& route, const RouteGraph& graph,
                  const RouteServerParameters& parameters) {
  constexpr double kThere = 1e-4;  // [m]
  const Vec2 node = graph.nodes[state.nextNode].place;
  const double distance = (node - robot).norm();
  const bool atBoundary = isBoundary(state, route);
  const bool isNear = distance <= (atBoundary ? parameters.boundaryRadiusToAchieveNode
                                              : parameters.radiusToAchieveNode);
  if (distance < kThere || (!isNear && state.isNear)) {
    return true;
  }
  state.isNear = isNear;
  if (atBoundary || !isNear) {
    return isNear;
  }
  const Vec2 before = graph.nodes[graph.edges[*state.current].from].place;
  const std::size_t next = route.edges[static_cast<std::size_t>(state.edge) + 1];
  return isPast(before, node, graph.nodes[graph.edges[next].to].place, robot);
}

bool goOn(TrackState& state, const Route& route, const RouteGraph& graph) {
  state.isNear = false;
  state.lastNode = state.nextNode;
  ++state.edge;
  if (state.edge >= static_cast<int>(route.edges.size())) {
    state.current.reset();
    return false;
  }
  state.current = route.edges[static_cast<std::size_t>(state.edge)];
  state.nextNode = graph.edges[*state.current].to;
  return true;
}

}  // namespace sim2d::nav2
