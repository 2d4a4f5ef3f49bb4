#include "sim2d/nav/nav2/route/EdgeScorers.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/FrameTransform.h"
#include "sim2d/nav/nav2/costmap/FootprintCost.h"

namespace sim2d::nav2 {
namespace {

/// One edge as a scorer looks at it.
struct ScoredEdge {
  const RouteGraph& graph;
  const RouteEdge& edge;
  EdgeRole role;
  const ScoringScene& scene;

  double length() const { return graph.lengthOf(edge); }
  Vec2 along() const { return graph.nodes[edge.to].place - graph.nodes[edge.from].place; }
};
using Cost = std::optional<double>;

/// Length over the share of the speed that may be driven there.
Cost costOf(const DistanceScorerParameters& scorer, const ScoredEdge& at) {
  const double speed = at.edge.metadata.number(scorer.speedTag).value_or(1.0);
  return speed > 0.0 ? Cost(scorer.weight * at.length() / speed) : std::nullopt;
}

/// The time that was measured, else length over speed.
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

/// The greatest or mean cost of cells on the straight line, as a share of max_cost.
Cost costOf(const CostmapScorerParameters& scorer, const ScoredEdge& at) {
  const bool isLocal = scorer.costmapTopic.find("local") != std::string::npos;
  const Costmap* const costmap = isLocal ? at.scene.local : at.scene.global;
  if (costmap == nullptr) {
    return std::nullopt;
  }
  const Pose2 frame = isLocal ? at.scene.localFrame : Pose2();
  const auto cellOf = [&](std::size_t node) {
    return costmap->worldToCell(toFrame(frame, {at.graph.nodes[node].place, 0.0}).position);
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

/// Costs of the classes of the edge and of the node that it leads to.
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

std::optional<std::uint32_t> idOf(const std::string& word) {
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
    const auto id = idOf(words[1]);
    const auto cost = words.size() == 3 ? base::parseDouble(words[2]) : std::nullopt;
    if (id && cost) {
      costs[*id] = *cost;
    }
    return id && cost;
  }
  std::vector<std::uint32_t> ids;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto id = idOf(words[i]);
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

bool EdgeScorers::needsPoses() const {
  return std::any_of(settings_.begin(), settings_.end(), [](const auto& each) {
    return std::holds_alternative<OrientationScorerParameters>(each.second);
  });
}

std::optional<double> EdgeScorers::cost(const RouteGraph& graph, const RouteEdge& edge,
                                        EdgeRole role, const ScoringScene& scene) const {
  double sum = 0.0;
  for (const auto& [name, settings] : settings_) {
    const Cost cost = std::visit(
        [&](const auto& scorer) {
          return costOf(scorer, {graph, edge, role, scene});
        },
        settings);
    if (!cost) {
      return std::nullopt;
    }
    sum += *cost;
  }
  return sum;
}

}  // namespace sim2d::nav2
