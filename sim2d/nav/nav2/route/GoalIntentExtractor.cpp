#include "sim2d/nav/nav2/route/GoalIntentExtractor.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <tuple>

#include <queue>

#include "sim2d/map/Outlines.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace sim2d::nav2 {
namespace {

bool isObstacleCost(std::uint8_t cost) {
  return cost >= kInscribed && cost != kNoInformation;
}

bool isLineFree(const Costmap& costmap, Cell from, Cell to) {
  bool isFree = true;
  visitLine(from, to, [&](Cell cell) {
    isFree = !isObstacleCost(costmap.at(cell));
    return isFree;
  });
  return isFree;
}

/// Dijkstra's search through free cells with 8 neighbours.
class FreeSpaceSearch {
 public:
  FreeSpaceSearch(const Costmap& costmap, Cell from)
      : costmap_(costmap), costs_(costmap.costs().size(), std::numeric_limits<double>::infinity()) {
    reach(from, 0.0);
  }

  /// Index of the first of the wanted cells that is reached; nullopt if there is none within
  /// `maxIterations` cells.
  std::optional<std::size_t> run(const std::vector<std::optional<Cell>>& wanted,
                                 int maxIterations) {
    for (int i = 0; i < maxIterations && !open_.empty(); ++i) {
      const auto [cost, index] = open_.top();
      open_.pop();
      const auto width = static_cast<std::size_t>(costmap_.width());
      const Cell cell{static_cast<int>(index % width), static_cast<int>(index / width)};
      const auto goal = std::find_if(wanted.begin(), wanted.end(), [&](const auto& each) {
        return each && each->column == cell.column && each->row == cell.row;
      });
      if (goal != wanted.end()) {
        return static_cast<std::size_t>(goal - wanted.begin());
      }
      if (cost <= costs_[index]) {
        expand(cell, cost);
      }
    }
    return std::nullopt;
  }

 private:
  void reach(Cell cell, double cost) {
    double& known = costs_[costmap_.indexOf(cell)];
    if (cost < known) {
      known = cost;
      open_.emplace(cost, costmap_.indexOf(cell));
    }
  }
  void expand(Cell cell, double cost) {
    for (int row = -1; row <= 1; ++row) {
      for (int column = -1; column <= 1; ++column) {
        const Cell next{cell.column + column, cell.row + row};
        if (costmap_.contains(next) && !isObstacleCost(costmap_.at(next))) {
          reach(next, cost + std::sqrt(static_cast<double>(row * row + column * column)));
        }
      }
    }
  }

  using Entry = std::tuple<double, std::size_t>;
  const Costmap& costmap_;
  std::vector<double> costs_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

/// Cosine of the angle between two vectors; 0 if one has no length.
double normalizedDot(const Vec2& a, const Vec2& b) {
  constexpr double kMinimum = 1e-6;
  const double lengths = a.norm() * b.norm();
  return lengths < kMinimum ? 0.0 : a.dot(b) / lengths;
}

constexpr double kEpsilon = 1e-6;

void dropFirst(Route& route, const RouteGraph& graph) {
  route.cost -= route.costs.front();
  route.start = graph.edges[route.edges.front()].to;
  route.edges.erase(route.edges.begin());
  route.costs.erase(route.costs.begin());
}

}  // namespace

std::vector<std::size_t> nearestNodes(const RouteGraph& graph, const Vec2& place,
                                      std::size_t count) {
  std::vector<std::size_t> nodes(graph.nodes.size());
  std::iota(nodes.begin(), nodes.end(), std::size_t{0});
  const auto distance = [&](std::size_t node) {
    return (graph.nodes[node].place - place).squaredNorm();
  };
  std::stable_sort(nodes.begin(), nodes.end(),
                   [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  nodes.resize(std::min(nodes.size(), count));
  return nodes;
}

std::optional<std::size_t> nodeOfPose(const RouteGraph& graph, const Vec2& place,
                                      const Costmap* costmap,
                                      const RouteServerParameters& parameters) {
  const auto count = static_cast<std::size_t>(std::max(parameters.numNearestNodes, 1));
  const std::vector<std::size_t> nodes =
      nearestNodes(graph, place, parameters.enableNnSearch ? count : 1);
  if (nodes.empty()) {
    return std::nullopt;
  }
  if (!parameters.enableNnSearch || nodes.size() == 1 || costmap == nullptr) {
    return nodes.front();
  }
  const auto from = costmap->worldToCell(place);
  const auto nearest = costmap->worldToCell(graph.nodes[nodes.front()].place);
  if (!from || !nearest || isLineFree(*costmap, *nearest, *from)) {
    return nodes.front();
  }
  std::vector<std::optional<Cell>> wanted;
  wanted.reserve(nodes.size());
  for (const std::size_t node : nodes) {
    wanted.push_back(costmap->worldToCell(graph.nodes[node].place));
  }
  const auto reached =
      FreeSpaceSearch(*costmap, *from).run(wanted, parameters.maxNnSearchIterations);
  return nodes[reached.value_or(0)];
}

Route pruneRoute(Route route, const RouteGraph& graph, const RouteRequest& request, bool isFirst,
                 const RouteServerParameters& parameters, ContinuedEdge& continued) {
  const std::optional<std::size_t> followed = continued.edge;
  continued.edge.reset();
  if (route.edges.empty() || (!request.usesPoses && isFirst)) {
    return route;
  }
  const RouteEdge& first = graph.edges[route.edges.front()];
  const Vec2 begin = graph.nodes[first.from].place, next = graph.nodes[first.to].place;
  const Vec2 on = closestOnSegment({begin, next}, request.start.position);
  const Vec2 past = request.start.position - begin;
  if (normalizedDot(next - begin, past) > kEpsilon &&
      past.norm() > parameters.minPruneDistFromStart &&
      (on - request.start.position).norm() <= parameters.maxPruneDistFromEdge) {
    if (followed == route.edges.front()) {
      continued = {followed, on};
    }
    dropFirst(route, graph);
  }
  if (!parameters.pruneGoal || !request.usesPoses || route.edges.empty()) {
    return route;
  }
  const RouteEdge& last = graph.edges[route.edges.back()];
  const Vec2 before = graph.nodes[last.from].place, end = graph.nodes[last.to].place;
  const Vec2 back = request.goal.position - end;
  const Vec2 onLast = closestOnSegment({before, end}, request.goal.position);
  if (normalizedDot(end - before, back) < -kEpsilon &&
      back.norm() > parameters.minPruneDistFromGoal &&
      (onLast - request.goal.position).norm() <= parameters.maxPruneDistFromEdge) {
    route.cost -= route.costs.back();
    route.edges.pop_back();
    route.costs.pop_back();
  }
  return route;
}

}  // namespace sim2d::nav2
