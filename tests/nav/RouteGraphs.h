#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/route/RouteGraph.h"

/// Graphs of nav2_route for tests.
namespace routes {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else

struct Way {
  std::uint32_t id, from, to;  // ids
};

inline RouteGraph graphOf(const std::vector<std::pair<std::uint32_t, Vec2>>& nodes,
                          const std::vector<Way>& ways) {
  RouteGraph graph;
  for (const auto& [id, place] : nodes) {
    graph.indexOf.emplace(id, graph.nodes.size());
    RouteNode node;
    node.id = id;
    node.place = place;
    graph.nodes.push_back(std::move(node));
  }
  graph.outgoing.resize(graph.nodes.size());
  for (const Way& way : ways) {
    RouteEdge edge;
    edge.id = way.id;
    edge.from = *graph.nodeOf(way.from);
    edge.to = *graph.nodeOf(way.to);
    graph.outgoing[edge.from].push_back(graph.edges.size());
    graph.edges.push_back(std::move(edge));
  }
  return graph;
}

/// 3 (0, 2) --13--> 2 (4, 3)
///    ^ 12             ^ 11 \ 15
/// 0 (0, 0) --10--> 1 (4, 0) --14--> 4 (8, 0)
inline RouteGraph house() {
  return graphOf({{0, {0, 0}}, {1, {4, 0}}, {2, {4, 3}}, {3, {0, 2}}, {4, {8, 0}}},
                 {{10, 0, 1}, {11, 1, 2}, {12, 0, 3}, {13, 3, 2}, {14, 1, 4}, {15, 2, 4}});
}

inline RouteEdge& edgeOf(RouteGraph& graph, std::uint32_t id) {
  for (RouteEdge& edge : graph.edges) {
    if (edge.id == id) {
      return edge;
    }
  }
  return graph.edges.front();
}

}  // namespace routes
