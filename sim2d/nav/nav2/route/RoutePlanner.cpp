#include "sim2d/nav/nav2/route/RoutePlanner.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include <queue>

namespace sim2d::nav2 {
namespace {

constexpr std::size_t kNoEdge = std::numeric_limits<std::size_t>::max();

/// What the search has found of a node.
struct Reached {
  double cost = std::numeric_limits<double>::infinity();
  double lastCost = 0.0;       // of the edge that leads here
  std::size_t edge = kNoEdge;  // that leads here
};

class Search {
 public:
  Search(const RouteGraph& graph, std::size_t start, std::size_t goal, const BlockedEdges& blocked,
         const EdgeScorers& scorers, const ScoringScene& scene)
      : graph_(graph),
        start_(start),
        goal_(goal),
        blocked_(blocked),
        scorers_(scorers),
        scene_(scene),
        reached_(graph.nodes.size()) {}

  RouteResult run(int maxIterations);

 private:
  bool expand(std::size_t node, RouteResult& result);
  EdgeRole roleOf(const RouteEdge& edge) const;
  Route route() const;

  const RouteGraph& graph_;
  std::size_t start_, goal_;
  const BlockedEdges& blocked_;
  const EdgeScorers& scorers_;
  const ScoringScene& scene_;
  std::vector<Reached> reached_;
  using Entry = std::tuple<double, std::size_t, std::size_t>;  // cost, order of finding, node
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  std::size_t found_ = 0;
};

EdgeRole Search::roleOf(const RouteEdge& edge) const {
  if (edge.from == start_) {
    return EdgeRole::Start;
  }
  return edge.to == goal_ ? EdgeRole::End : EdgeRole::None;
}

/// False: an edge has no valid cost.
bool Search::expand(std::size_t node, RouteResult& result) {
  for (const std::size_t index : graph_.outgoing[node]) {
    const RouteEdge& edge = graph_.edges[index];
    if (blocked_.count(edge.id) != 0) {
      continue;
    }
    std::optional<double> cost = edge.cost;
    if (edge.overridable && !scorers_.isEmpty()) {
      cost = scorers_.cost(graph_, edge, roleOf(edge), scene_);
    } else if (edge.cost <= 0.0) {
      result.error = RouteError::NoValidGraph;
      result.text = "edge " + std::to_string(edge.id) + " has no cost above 0";
      return false;
    }
    if (cost && reached_[node].cost + *cost < reached_[edge.to].cost) {
      reached_[edge.to] = {reached_[node].cost + *cost, *cost, index};
      open_.emplace(reached_[edge.to].cost, ++found_, edge.to);
    }
  }
  return true;
}

Route Search::route() const {
  Route route;
  route.start = start_;
  for (std::size_t node = goal_; node != start_; node = graph_.edges[route.edges.back()].from) {
    route.edges.push_back(reached_[node].edge);
    route.costs.push_back(reached_[node].lastCost);
  }
  std::reverse(route.edges.begin(), route.edges.end());
  std::reverse(route.costs.begin(), route.costs.end());
  route.cost = reached_[goal_].cost;
  return route;
}

RouteResult Search::run(int maxIterations) {
  RouteResult result;
  reached_[start_].cost = 0.0;
  open_.emplace(0.0, 0, start_);
  for (int iterations = 0; !open_.empty(); ++iterations) {
    if (maxIterations > 0 && iterations >= maxIterations) {
      result.error = RouteError::Timeout;
      result.text = "the limit of iterations (max_iterations) is used up";
      return result;
    }
    const auto [cost, order, node] = open_.top();
    open_.pop();
    if (cost > reached_[node].cost) {
      continue;  // a cheaper way was found meanwhile
    }
    if (node == goal_) {
      result.route = route();
      return result;
    }
    if (!expand(node, result)) {
      return result;
    }
  }
  result.error = RouteError::NoValidRoute;
  result.text = "no edges lead from node " + std::to_string(graph_.nodes[start_].id) + " to node " +
                std::to_string(graph_.nodes[goal_].id);
  return result;
}

}  // namespace

RouteResult findRoute(const RouteGraph& graph, const RouteQuery& query, const BlockedEdges& blocked,
                      const EdgeScorers& scorers, const ScoringScene& scene) {
  if (scorers.needsPoses() && !scene.request.usesPoses) {
    RouteResult result;
    result.error = RouteError::InvalidEdgeScorerUse;
    result.text = "a scorer of headings needs poses, not ids";
    return result;
  }
  return Search(graph, query.start, query.goal, blocked, scorers, scene).run(query.maxIterations);
}

}  // namespace sim2d::nav2
