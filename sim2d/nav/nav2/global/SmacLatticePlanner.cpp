#include "sim2d/nav/nav2/global/SmacLatticePlanner.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace sim2d::nav2 {
namespace {

constexpr double kOnTheSpot = 1e-4;  // [m]
constexpr double kNoArc = 1e-3;      // [m], arc length

CarMotion carOf(const SmacLatticeParameters& parameters) {
  return parameters.allowReverseExpansion ? CarMotion::ReedsShepp : CarMotion::Dubins;
}

bool isQuadratic(const SmacLatticeParameters& parameters, Distro distro) {
  return distro >= Distro::Lyrical && parameters.useQuadraticCostPenalty;
}

ObstacleHeuristic::Settings heuristicOf(const SmacLatticeParameters& parameters, Distro distro) {
  ObstacleHeuristic::Settings settings;
  settings.costPenalty = parameters.costPenalty;
  settings.isQuadratic = isQuadratic(parameters, distro);
  settings.allowUnknown = parameters.allowUnknown;
  settings.isDownsampled = parameters.downsampleObstacleHeuristic;
  return settings;
}

}  // namespace

SmacLatticePlanner::SmacLatticePlanner(const SmacLatticeParameters& parameters, Distro distro)
    : parameters_(parameters), distro_(distro) {
  assert(parameters.lattice != nullptr);
}

PlanResult SmacLatticePlanner::plan(const PlanRequest& request) {
  const Costmap& costmap = request.costmap;
  const auto search = [&] {
    return LatticeSearch(parameters_, distro_, request, obstacles_)
        .plan(inCells(costmap, request.start, true), inCells(costmap, request.goal, true));
  };
  return planOverPoses(costmap, request, parameters_,
                       {carOf(parameters_), parameters_.lattice->turningRadius}, search);
}

int Lattice::nearestHeading(double heading) const {
  int nearest = 0;
  for (int i = 1; i < size(); ++i) {
    const auto off = [&](int number) {
      return std::abs(base::angleDiff(headings[static_cast<std::size_t>(number)], heading));
    };
    nearest = off(i) < off(nearest) ? i : nearest;
  }
  return nearest;
}

LatticeSearch::LatticeSearch(const SmacLatticeParameters& parameters, Distro distro,
                             const PlanRequest& request, ObstacleHeuristic& obstacles)
    : SmacPoseSearch({Kind::Lattice, parameters, distro, request.costmap, request, obstacles,
                      carOf(parameters),
                      parameters.lattice->turningRadius / request.costmap.resolution(),
                      parameters.lattice->size(), heuristicOf(parameters, distro)}),
      parameters_(parameters),
      lattice_(*parameters.lattice),
      cellSize_(request.costmap.resolution()) {}

double LatticeSearch::cost(const LatticePrimitive* before, const LatticePrimitive& primitive,
                           bool isBackward, double cellCost) const {
  const double length = primitive.length / cellSize_;
  if (before == nullptr) {
    return length;
  }
  const double share = cellCost / kSmacMaxCost;
  const double penalty =
      parameters_.costPenalty * (isQuadratic(parameters_, setup().distro) ? share * share : share);
  if (primitive.length < kOnTheSpot) {
    return parameters_.rotationPenalty * (1.0 + penalty);
  }
  double cost = length * (1.0 - parameters_.retrospectivePenalty + penalty);
  if (primitive.arcLength >= kNoArc) {
    const bool isSameWay = before->isLeftTurn == primitive.isLeftTurn;
    cost *= isSameWay ? parameters_.nonStraightPenalty
                      : parameters_.nonStraightPenalty + parameters_.changePenalty;
  }
  return isBackward ? cost * parameters_.reversePenalty : cost;
}

double LatticeSearch::curveEstimate(const Node& node, const Pose2& goal, double /*round*/) {
  return curveLength(node, goal);
}

/// Backward motion uses the primitives of the opposite heading.
const std::vector<LatticePrimitive>& LatticeSearch::primitivesFrom(int heading,
                                                                   bool isBackward) const {
  const int from = isBackward ? lattice_.oppositeOf(heading) : heading;
  return lattice_.primitives[static_cast<std::size_t>(from)];
}

const LatticePrimitive* LatticeSearch::primitiveInto(const Node& node) const {
  return node.parent < 0 ? nullptr
                         : &primitivesFrom(nodeWith(node.parent).heading,
                                           node.isBackward)[static_cast<std::size_t>(node.step)];
}

/// Expands forward, and with `allow_reverse_expansion` also backward.
void LatticeSearch::expand(int index) {
  for (const bool isBackward : {false, true}) {
    const int heading = nodeWith(index).heading;
    const auto steps = static_cast<int>(primitivesFrom(heading, isBackward).size());
    for (int step = 0; step < steps && (!isBackward || parameters_.allowReverseExpansion); ++step) {
      applyStep(index, step, isBackward);
    }
  }
}

void LatticeSearch::applyStep(int from, int step, bool isBackward) {
  const Node node = nodeWith(from);
  const LatticePrimitive& primitive =
      primitivesFrom(node.heading, isBackward)[static_cast<std::size_t>(step)];
  Node next;
  next.heading = isBackward ? lattice_.oppositeOf(primitive.endHeading) : primitive.endHeading;
  next.pose = {node.pose.position + primitive.poses.back().position / cellSize_,
               headingOf(next.heading)};
  const int index = unvisitedNode(next.pose.position, next.heading);
  if (index < 0) {
    return;
  }
  const auto cellCost = costAlong(node.pose, primitive, isBackward);
  const auto endCost = costAt(next.pose);
  if (!cellCost || !endCost) {
    return;
  }
  const double highest = std::max<double>(*cellCost, *endCost);
  next.g = node.g + cost(primitiveInto(node), primitive, isBackward, highest);
  next.parent = from;
  next.step = step;
  next.isBackward = isBackward;
  offer(index, next);
}

/// The maximum cost along a primitive, sampled about once per cell; nullopt in a collision.
std::optional<double> LatticeSearch::costAlong(const Pose2& from, const LatticePrimitive& primitive,
                                               bool isBackward) const {
  double highest = 0.0;
  const Pose2* last = nullptr;
  for (const Pose2& each : primitive.poses) {
    if (last != nullptr &&
        (each.position - last->position).squaredNorm() <= 2.0 * cellSize_ * cellSize_) {
      continue;
    }
    last = &each;
    const double heading = isBackward ? base::wrapToPi(each.heading + base::kPi) : each.heading;
    const auto cost = costAt({from.position + each.position / cellSize_, heading});
    if (!cost) {
      return std::nullopt;
    }
    highest = std::max<double>(highest, *cost);
  }
  return highest;
}

/// Appends the poses along the primitive.
void LatticeSearch::addPoses(const Node& parent, const Node& node, Path& path) const {
  const std::vector<Pose2>& poses = primitiveInto(node)->poses;
  for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
    const double heading =
        node.isBackward ? base::wrapToPi(poses[i].heading + base::kPi) : poses[i].heading;
    path.push_back({parent.pose.position + poses[i].position / cellSize_, heading});
  }
  path.push_back(node.pose);
}

}  // namespace sim2d::nav2
