#include "sim2d/nav/nav2/route/RoutePlanner.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

#include <queue>

#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace sim2d::nav2 {
namespace {

/// Position of an edge in a search: it begins at the start or ends at the goal.
enum class EdgeRole : std::uint8_t { None, Start, End };

/// An edge with the data for scoring it.
struct ScoredEdge {
  const RouteGraph& graph;
  const RouteEdge& edge;
  EdgeRole role;
  const ScoringScene& scene;

  double length() const { return graph.lengthOf(edge); }
  Vec2 along() const { return graph.nodes[edge.to].place - graph.nodes[edge.from].place; }
};
using Cost = std::optional<double>;

/// Length divided by the allowed fraction of the speed.
Cost costOf(const DistanceScorerParameters& scorer, const ScoredEdge& at) {
  const double speed = at.edge.metadata.number(scorer.speedTag).value_or(1.0);
  return speed > 0.0 ? Cost(scorer.weight * at.length() / speed) : std::nullopt;
}

/// The measured time, or else length / speed.
Cost costOf(const TimeScorerParameters& scorer, const ScoredEdge& at) {
  const double measured = at.edge.metadata.number(scorer.timeTag).value_or(0.0);
  if (measured > 0.0) {
    return scorer.weight * measured;
  }
  const double given = at.edge.metadata.number(scorer.speedTag).value_or(0.0);
  const double speed = given > 0.0 ? given : scorer.maxVel;
  return speed > 0.0 ? Cost(scorer.weight * at.length() / speed) : std::nullopt;
}

Cost costOf(const PenaltyScorerParameters& scorer, const ScoredEdge& at) {
  return scorer.weight * at.edge.metadata.number(scorer.penaltyTag).value_or(0.0);
}

/// The maximum or mean cost of the cells on the straight line, relative to max_cost.
Cost costOf(const CostmapScorerParameters& scorer, const ScoredEdge& at) {
  const auto inputs = at.scene.scene.costmapOf(scorer.costmapTopic);
  const Costmap* const costmap = inputs.first;
  if (costmap == nullptr) {
    return std::nullopt;
  }
  const auto cellOf = [&](std::size_t node) {
    return costmap->worldToCell(toFrame(inputs.second, {at.graph.nodes[node].place, 0.0}).position);
  };
  const auto from = cellOf(at.edge.from);
  const auto to = cellOf(at.edge.to);
  if (!from || !to) {
    return scorer.invalidOffMap ? std::nullopt : Cost(0.0);
  }
  double greatest = 0.0, sum = 0.0;
  int looked = 0, number = 0;
  bool isFree = true;
  visitLine(*from, *to, [&](Cell cell) {
    if (number++ % std::max(scorer.checkResolution, 1) != 0) {
      return true;
    }
    const double cost = costmap->at(cell);
    isFree =
        !(scorer.invalidOnCollision && scorer.maxCost != kNoInformation && cost >= scorer.maxCost);
    greatest = cost != kNoInformation ? std::max(greatest, cost) : greatest;
    sum += cost;
    ++looked;
    return isFree;
  });
  if (!isFree) {
    return std::nullopt;
  }
  const double cost = scorer.useMaximum ? greatest : sum / looked;
  return scorer.weight * cost / scorer.maxCost;
}

/// Costs of the semantic classes of the edge and of its end node.
Cost costOf(const SemanticScorerParameters& scorer, const ScoredEdge& at) {
  double cost = 0.0;
  for (const RouteMetadata* const metadata :
       {&at.graph.nodes[at.edge.to].metadata, &at.edge.metadata}) {
    for (const auto& [name, value] : scorer.costs) {
      const bool isOne = scorer.semanticKey.empty()
                             ? metadata->has(name)
                             : metadata->text(scorer.semanticKey) == std::optional(name);
      cost += isOne ? value : 0.0;
    }
  }
  return scorer.weight * cost;
}

/// Difference of headings between the first edge and the start, or the last edge and the goal.
Cost costOf(const OrientationScorerParameters& scorer, const ScoredEdge& at) {
  if (at.role != (scorer.isOfGoal ? EdgeRole::End : EdgeRole::Start)) {
    return 0.0;
  }
  const Vec2 along = at.along();
  const double heading =
      scorer.isOfGoal ? at.scene.request.goal.heading : at.scene.request.start.heading;
  const double turn = std::fabs(base::wrapToPi(base::atan2(along.y(), along.x()) - heading));
  if (scorer.useOrientationThreshold && turn > scorer.orientationTolerance) {
    return std::nullopt;
  }
  return scorer.orientationWeight * turn;
}

Cost costOf(const DynamicEdgesParameters& /*scorer*/, const ScoredEdge& at) {
  const DynamicEdges& edges = at.scene.dynamicEdges;
  if (edges.closed.count(at.edge.id) != 0) {
    return std::nullopt;
  }
  const auto found = edges.costs.find(at.edge.id);
  return found == edges.costs.end() ? 0.0 : found->second;
}

std::optional<std::uint32_t> parseEdgeId(const std::string& word) {
  const auto number = base::parseInt(word);
  return number && *number >= 0 ? std::optional(static_cast<std::uint32_t>(*number)) : std::nullopt;
}

}  // namespace

bool DynamicEdges::apply(const std::string& text) {
  std::vector<std::string> words;
  for (const std::string& word : base::split(text, ' ')) {
    if (!word.empty()) {
      words.push_back(word);
    }
  }
  if (words.size() < 2) {
    return false;
  }
  const bool isCost = words.front() == "cost";
  if (isCost) {
    const auto id = parseEdgeId(words[1]);
    const auto cost = words.size() == 3 ? base::parseDouble(words[2]) : std::nullopt;
    if (id && cost) {
      costs[*id] = *cost;
    }
    return id && cost;
  }
  std::vector<std::uint32_t> ids;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto id = parseEdgeId(words[i]);
    if (!id) {
      return false;
    }
    ids.push_back(*id);
  }
  const bool closes = words.front() == "close", opens = words.front() == "open";
  for (const std::uint32_t id : ids) {
    if (closes) {
      closed.insert(id);
    } else if (opens) {
      closed.erase(id);
    }
  }
  return closes || opens;
}

namespace {

/// Whether a scorer compares headings with those of poses, which a request by ids does not have.
bool needPoses(const EdgeScorers& scorers) {
  return std::any_of(scorers.begin(), scorers.end(), [](const auto& each) {
    return std::holds_alternative<OrientationScorerParameters>(each.second);
  });
}

/// The sum of the costs of all scorers; nullopt: the edge is not usable.
Cost sumOfCosts(const EdgeScorers& scorers, const ScoredEdge& edge) {
  double sum = 0.0;
  for (const auto& [name, settings] : scorers) {
    const Cost cost =
        std::visit([&](const auto& scorer) { return costOf(scorer, edge); }, settings);
    if (!cost) {
      return std::nullopt;
    }
    sum += *cost;
  }
  return sum;
}

constexpr std::size_t kNoEdge = std::numeric_limits<std::size_t>::max();

/// Search data of a node.
struct NodeState {
  double cost = std::numeric_limits<double>::infinity();
  double lastCost = 0.0;       // of the edge into this node
  std::size_t edge = kNoEdge;  // into this node
};

class RouteSearch {
 public:
  RouteSearch(const RouteGraph& graph, const RouteQuery& query, const BlockedEdges& blocked,
              const EdgeScorers& scorers, const ScoringScene& scene)
      : graph_(graph),
        query_(query),
        blocked_(blocked),
        scorers_(scorers),
        scene_(scene),
        nodeStates_(graph.nodes.size()) {}

  RouteResult run() {
    nodeStates_[query_.start].cost = 0.0;
    open_.emplace(0.0, 0, query_.start);
    for (int iterations = 0; !open_.empty(); ++iterations) {
      if (query_.maxIterations > 0 && iterations >= query_.maxIterations) {
        return {RouteError::Timeout, "the limit of iterations (max_iterations) is reached", {}};
      }
      const auto [cost, order, node] = open_.top();
      open_.pop();
      if (cost > nodeStates_[node].cost) {
        continue;  // a cheaper path was found after insertion
      }
      if (node == query_.goal) {
        return {RouteError::None, {}, route()};
      }
      if (auto failure = expand(node)) {
        return *std::move(failure);
      }
    }
    return {RouteError::NoValidRoute,
            "no edges lead from node " + std::to_string(graph_.nodes[query_.start].id) +
                " to node " + std::to_string(graph_.nodes[query_.goal].id),
            {}};
  }

 private:
  /// Returns the failure if an edge has no valid cost.
  std::optional<RouteResult> expand(std::size_t node) {
    for (const std::size_t index : graph_.outgoing[node]) {
      const RouteEdge& edge = graph_.edges[index];
      if (blocked_.count(edge.id) != 0) {
        continue;
      }
      Cost cost = edge.cost;
      if (edge.overridable && !scorers_.empty()) {
        cost = sumOfCosts(scorers_, {graph_, edge, roleOf(edge), scene_});
      } else if (edge.cost <= 0.0) {
        return RouteResult{RouteError::NoValidGraph,
                           "edge " + std::to_string(edge.id) + " has no cost above 0",
                           {}};
      }
      if (cost && nodeStates_[node].cost + *cost < nodeStates_[edge.to].cost) {
        nodeStates_[edge.to] = {nodeStates_[node].cost + *cost, *cost, index};
        open_.emplace(nodeStates_[edge.to].cost, ++insertionCount_, edge.to);
      }
    }
    return std::nullopt;
  }

  EdgeRole roleOf(const RouteEdge& edge) const {
    if (edge.from == query_.start) {
      return EdgeRole::Start;
    }
    return edge.to == query_.goal ? EdgeRole::End : EdgeRole::None;
  }

  Route route() const {
    Route route;
    route.start = query_.start;
    for (std::size_t node = query_.goal; node != query_.start;
         node = graph_.edges[route.edges.back()].from) {
      route.edges.push_back(nodeStates_[node].edge);
      route.costs.push_back(nodeStates_[node].lastCost);
    }
    std::reverse(route.edges.begin(), route.edges.end());
    std::reverse(route.costs.begin(), route.costs.end());
    route.cost = nodeStates_[query_.goal].cost;
    return route;
  }

  const RouteGraph& graph_;
  const RouteQuery& query_;
  const BlockedEdges& blocked_;
  const EdgeScorers& scorers_;
  const ScoringScene& scene_;
  std::vector<NodeState> nodeStates_;
  using Entry = std::tuple<double, std::size_t, std::size_t>;  // cost, insertion order, node
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  std::size_t insertionCount_ = 0;
};

}  // namespace

RouteResult findRoute(const RouteGraph& graph, const RouteQuery& query, const BlockedEdges& blocked,
                      const EdgeScorers& scorers, const ScoringScene& scene) {
  if (needPoses(scorers) && !scene.request.usesPoses) {
    return {RouteError::InvalidEdgeScorerUse, "a scorer of headings needs poses, not ids", {}};
  }
  return RouteSearch(graph, query, blocked, scorers, scene).run();
}

}  // namespace sim2d::nav2
