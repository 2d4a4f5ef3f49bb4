#include "sim2d/nav/nav2/global/SmacLatticePlanner.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "sim2d/nav/nav2/costmap/Footprint.h"
#include "sim2d/nav/nav2/global/SmacCommon.h"

namespace sim2d::nav2 {
namespace {

constexpr double kNoLatticeTolerance = 1e-3;  // [cells]

Pose2 inCellsOf(const Costmap& costmap, const Pose2& pose) {
  const Vec2 place = (pose.position - costmap.origin()) / costmap.resolution();
  return {place.array().floor() + 0.5, pose.heading};
}

Cell cellBelow(const Pose2& pose) {
  return {static_cast<int>(pose.position.x()), static_cast<int>(pose.position.y())};
}

/// The goal with the headings that `goal_heading_mode` allows.
std::vector<Pose2> latticeGoals(const SmacLatticeParameters& parameters, Distro distro,
                                const Pose2& goal) {
  const Lattice& lattice = *parameters.lattice;
  const int heading = lattice.nearestHeading(goal.heading);
  std::vector<int> headings = {heading};
  if (distro >= Distro::Kilted && parameters.goalHeadingMode == "BIDIRECTIONAL") {
    headings.push_back(lattice.oppositeOf(heading));
  } else if (distro >= Distro::Kilted && parameters.goalHeadingMode == "ALL_DIRECTION") {
    for (int i = 1; i < lattice.size(); ++i) {
      headings.push_back((heading + i) % lattice.size());
    }
  }
  std::vector<Pose2> goals;
  goals.reserve(headings.size());
  for (const int each : headings) {
    goals.push_back({goal.position, lattice.headings[static_cast<std::size_t>(each)]});
  }
  return goals;
}

}  // namespace

SmacLatticePlanner::SmacLatticePlanner(const SmacLatticeParameters& parameters, Distro distro)
    : parameters_(parameters), distro_(distro) {
  assert(parameters.lattice != nullptr);
}

PlanResult SmacLatticePlanner::plan(const PlanRequest& request) {
  const Costmap& costmap = request.costmap;
  if (!costmap.worldToCell(request.start.position)) {
    return {PlanError::StartOutsideMap, {}, 0};
  }
  if (!costmap.worldToCell(request.goal.position)) {
    return {PlanError::GoalOutsideMap, {}, 0};
  }
  if (!std::isfinite(request.start.heading) || !std::isfinite(request.goal.heading)) {
    return {PlanError::Unknown, {}, 0};
  }
  PlanResult result = planIn(costmap, request);
  for (Pose2& pose : result.path) {
    pose.position = costmap.origin() + costmap.resolution() * pose.position;
  }
  if (parameters_.smoothPath && result.iterations > 1) {
    const CarMotion car =
        parameters_.allowReverseExpansion ? CarMotion::ReedsShepp : CarMotion::Dubins;
    smoothSmacPath(result.path, parameters_, costmap,
                   CarModel{car, parameters_.lattice->turningRadius});
  }
  return result;
}

/// Plans a path in cell coordinates.
PlanResult SmacLatticePlanner::planIn(Costmap costmap, const PlanRequest& request) {
  const Pose2 start = inCellsOf(costmap, request.start);
  const std::vector<Pose2> goals =
      latticeGoals(parameters_, distro_, inCellsOf(costmap, request.goal));
  if (distro_ != Distro::Humble) {
    costmap.set(cellBelow(start), kFreeSpace);
  }
  LatticeSearch search({parameters_, distro_, *parameters_.lattice, costmap, request, obstacles_});
  if (distro_ == Distro::Humble && !search.costAt(start)) {
    return {PlanError::StartOccupied, {}, 0};
  }
  const auto isFree = [&](const Pose2& goal) { return search.costAt(goal).has_value(); };
  if (parameters_.tolerance / costmap.resolution() < kNoLatticeTolerance &&
      std::none_of(goals.begin(), goals.end(), isFree)) {
    return {PlanError::GoalOccupied, {}, 0};
  }
  if (cellBelow(start) == cellBelow(goals.front()) &&
      parameters_.lattice->nearestHeading(start.heading) ==
          parameters_.lattice->nearestHeading(goals.front().heading)) {
    return {PlanError::None, {{start.position, request.goal.heading}}, 0};
  }
  ObstacleHeuristic::Settings settings;
  settings.costPenalty = parameters_.costPenalty;
  settings.isQuadratic = distro_ >= Distro::Lyrical && parameters_.useQuadraticCostPenalty;
  settings.allowUnknown = parameters_.allowUnknown;
  settings.isDownsampled = parameters_.downsampleObstacleHeuristic;
  obstacles_.start(costmap, cellBelow(goals.front()), settings, parameters_.cacheObstacleHeuristic);
  return search.find(start, goals);
}

namespace {

constexpr double kLatticeStep =
    1.4142135623730951;              // [cells] a move of this length leaves the cell
constexpr double kOnTheSpot = 1e-4;  // [m]
constexpr double kNoArc = 1e-3;      // [m], arc length
constexpr std::size_t kMaxLatticeNodes = 5000000;

}  // namespace

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

LatticeSearch::LatticeSearch(const Context& context)
    : context_(context),
      slots_(context.costmap.costs().size() * context.lattice.headings.size(), -1) {}

CarMotion LatticeSearch::car() const {
  return context_.parameters.allowReverseExpansion ? CarMotion::ReedsShepp : CarMotion::Dubins;
}

double LatticeSearch::radius() const {
  return context_.lattice.turningRadius / context_.costmap.resolution();
}

bool LatticeSearch::isInside(const Vec2& place) const {
  return place.x() >= 0.0 && place.y() >= 0.0 && place.x() < context_.costmap.width() &&
         place.y() < context_.costmap.height();
}

std::optional<std::uint8_t> LatticeSearch::costAt(const Pose2& pose) const {
  if (!isInside(pose.position)) {
    return std::nullopt;
  }
  const Costmap& costmap = context_.costmap;
  const bool allowUnknown = context_.parameters.allowUnknown;
  const std::uint8_t cost =
      costmap.at({static_cast<int>(pose.position.x()), static_cast<int>(pose.position.y())});
  const PlanRequest& request = context_.request;
  if (!isSmacFree(cost, allowUnknown)) {
    return std::nullopt;
  }
  const double safe = request.circumscribedCost;
  if (request.footprint.empty() || (safe > 0.0 && cost < safe)) {
    return cost;
  }
  const Pose2 inWorld{costmap.origin() + costmap.resolution() * pose.position, pose.heading};
  const std::uint8_t edges = footprintCost(costmap, request.footprint, inWorld);
  return isEdgeCollision(edges, allowUnknown) ? std::nullopt : std::optional(cost);
}

double LatticeSearch::cost(const LatticePrimitive* before, const LatticePrimitive& primitive,
                           bool isBackward, double cellCost) const {
  const SmacLatticeParameters& given = context_.parameters;
  const double length = primitive.length / context_.costmap.resolution();
  if (before == nullptr) {
    return length;
  }
  const double share = cellCost / kSmacMaxCost;
  const bool isQuadratic = context_.distro >= Distro::Lyrical && given.useQuadraticCostPenalty;
  const double penalty = given.costPenalty * (isQuadratic ? share * share : share);
  if (primitive.length < kOnTheSpot) {
    return given.rotationPenalty * (1.0 + penalty);
  }
  double cost = length * (1.0 - given.retrospectivePenalty + penalty);
  if (primitive.arcLength >= kNoArc) {
    const bool isSameWay = before->isLeftTurn == primitive.isLeftTurn;
    cost *= isSameWay ? given.nonStraightPenalty : given.nonStraightPenalty + given.changePenalty;
  }
  return isBackward ? cost * given.reversePenalty : cost;
}

int LatticeSearch::nodeAt(const Vec2& place, int heading) {
  const Cell cell{static_cast<int>(place.x()), static_cast<int>(place.y())};
  std::int32_t& slot = slots_[context_.costmap.indexOf(cell) * context_.lattice.headings.size() +
                              static_cast<std::size_t>(heading)];
  if (slot < 0) {
    slot = static_cast<std::int32_t>(nodes_.size());
    nodes_.emplace_back();
    nodes_.back().g = std::numeric_limits<double>::max();
    nodes_.back().heading = heading;
  }
  return slot;
}

/// The maximum of the obstacle heuristic and the shortest curve to a goal.
double LatticeSearch::estimate(const Node& node) {
  const Vec2& place = node.pose.position;
  const double around =
      context_.obstacles.from({static_cast<int>(place.x()), static_cast<int>(place.y())});
  double curve = std::numeric_limits<double>::max();
  for (const Pose2& goal : goals_) {
    curve = std::min(curve, shortestCurve(car(), node.pose, goal, radius()).length());
  }
  return std::max(around, curve);
}

PlanResult LatticeSearch::find(const Pose2& start, const std::vector<Pose2>& goals) {
  const SmacLatticeParameters& given = context_.parameters;
  const SmacLimits limits = smacLimits(given, given.maxPlanningTime, kSmacHybridPerSecond);
  const double tolerance = given.tolerance / context_.costmap.resolution();
  goals_ = goals;
  for (const Pose2& goal : goals) {
    goalNodes_.push_back(nodeAt(goal.position, context_.lattice.nearestHeading(goal.heading)));
  }
  const int heading = context_.lattice.nearestHeading(start.heading);
  const int first = nodeAt(start.position, heading);
  Node& root = nodes_[static_cast<std::size_t>(first)];
  root.pose = {start.position, context_.lattice.headings[static_cast<std::size_t>(heading)]};
  root.g = 0.0;
  open_.push(0.0, static_cast<std::size_t>(first));
  PlanResult result;
  int nearGoal = 0;
  while (!open_.isEmpty() && result.iterations < limits.most && nodes_.size() <= kMaxLatticeNodes) {
    const std::size_t node = open_.pop().node;
    const int index = static_cast<int>(node);
    if (nodes_[node].isVisited) {
      continue;
    }
    if (context_.request.stop != nullptr && result.iterations % limits.checkInterval == 0) {
      context_.request.stop->check();
    }
    ++result.iterations;
    nodes_[node].isVisited = true;
    if (auto whole = tryAnalyticExpansion(index)) {
      result.path = *std::move(whole);
      return result;
    }
    if (std::find(goalNodes_.begin(), goalNodes_.end(), index) != goalNodes_.end()) {
      result.path = pathTo(index);
      return result;
    }
    if (nearest_.estimate < tolerance && ++nearGoal >= limits.maxOnApproach) {
      break;
    }
    expand(index);
  }
  if (nearest_.estimate < tolerance) {
    result.path = pathTo(static_cast<int>(nearest_.node));
  } else {
    result.error = open_.isEmpty() ? PlanError::NoValidPath : PlanError::Timeout;
  }
  return result;
}

/// Expands forward, and with `allow_reverse_expansion` backward by the primitives of the opposite
/// heading.
void LatticeSearch::expand(int index) {
  const int heading = nodes_[static_cast<std::size_t>(index)].heading;
  const auto go = [&](int from, bool isBackward) {
    for (const LatticePrimitive& primitive :
         context_.lattice.primitives[static_cast<std::size_t>(from)]) {
      applyStep(index, primitive, isBackward);
    }
  };
  go(heading, false);
  if (context_.parameters.allowReverseExpansion) {
    go(context_.lattice.oppositeOf(heading), true);
  }
}

void LatticeSearch::applyStep(int from, const LatticePrimitive& primitive, bool isBackward) {
  const Node node = nodes_[static_cast<std::size_t>(from)];
  const Lattice& lattice = context_.lattice;
  const Vec2 place =
      node.pose.position + primitive.poses.back().position / context_.costmap.resolution();
  if (!isInside(place)) {
    return;
  }
  const int heading = isBackward ? lattice.oppositeOf(primitive.endHeading) : primitive.endHeading;
  const int index = nodeAt(place, heading);
  if (nodes_[static_cast<std::size_t>(index)].isVisited) {
    return;
  }
  const auto cellCost = costAlong(node.pose, primitive, isBackward);
  const Pose2 pose{place, lattice.headings[static_cast<std::size_t>(heading)]};
  const auto endCost = costAt(pose);
  if (!cellCost || !endCost) {
    return;
  }
  const double highest = std::max<double>(*cellCost, *endCost);
  const double g = node.g + cost(node.primitive, primitive, isBackward, highest);
  Node& next = nodes_[static_cast<std::size_t>(index)];
  if (g < next.g) {
    next.pose = pose;
    next.g = g;
    next.parent = from;
    next.primitive = &primitive;
    next.isBackward = isBackward;
    const double toGo = estimate(next);
    nearest_.offer(toGo, static_cast<std::size_t>(index));
    open_.push(g + toGo, static_cast<std::size_t>(index));
  }
}

/// The maximum cost along a primitive, sampled about once per cell; nullopt in a collision.
std::optional<double> LatticeSearch::costAlong(const Pose2& from, const LatticePrimitive& primitive,
                                               bool isBackward) const {
  const double side = context_.costmap.resolution();
  double highest = 0.0;
  const Pose2* last = nullptr;
  for (const Pose2& each : primitive.poses) {
    if (last != nullptr && (each.position - last->position).squaredNorm() <= 2.0 * side * side) {
      continue;
    }
    last = &each;
    const double heading = isBackward ? base::wrapToPi(each.heading + base::kPi) : each.heading;
    const auto cost = costAt({from.position + each.position / side, heading});
    if (!cost) {
      return std::nullopt;
    }
    highest = std::max<double>(highest, *cost);
  }
  return highest;
}

/// Analytic expansion: tries a curve to the goal at intervals that decrease near the goal.
std::optional<Path> LatticeSearch::tryAnalyticExpansion(int index) {
  const double ratio = context_.parameters.analyticExpansionRatio;
  const Node node = nodes_[static_cast<std::size_t>(index)];
  closest_ = std::min(closest_, static_cast<int>(estimate(node)));
  const int desired =
      std::max(static_cast<int>(closest_ / ratio), static_cast<int>(std::ceil(ratio)));
  due_ = std::min(due_, desired);
  if (due_-- > 0) {
    return std::nullopt;
  }
  due_ = desired - 1;
  std::optional<Path> shortest;
  double least = std::numeric_limits<double>::max();
  for (const Pose2& goal : goals_) {
    const double length = shortestCurve(car(), node.pose, goal, radius()).length();
    auto curve = length < least ? analyticExpansionFrom(node, goal) : std::nullopt;
    if (curve) {
      least = length;
      shortest = std::move(curve);
    }
  }
  if (!shortest) {
    return std::nullopt;
  }
  Path path = pathTo(index);
  path.insert(path.end(), shortest->begin(), shortest->end());
  return path;
}

std::optional<Path> LatticeSearch::analyticExpansionFrom(const Node& node,
                                                         const Pose2& goal) const {
  const ShortestCurve curve = shortestCurve(car(), node.pose, goal, radius());
  const double length = curve.length();
  const SmacLatticeParameters& given = context_.parameters;
  if (length > given.analyticExpansionMaxLength / context_.costmap.resolution() ||
      length < kLatticeStep) {
    return std::nullopt;
  }
  const int pieces = static_cast<int>(length / kLatticeStep);
  Path path;
  bool wasCheap = false, isLeft = false;  // a cheap cell has been followed by an expensive one
  for (int i = 1; i <= pieces; ++i) {
    path.push_back(i < pieces ? curve.at(length * i / pieces) : goal);
    const auto cost = costAt(path.back());
    if (!cost) {
      return std::nullopt;
    }
    const bool isCheap = *cost <= given.analyticExpansionMaxCost;
    isLeft = isLeft || (wasCheap && !isCheap);
    wasCheap = wasCheap || isCheap;
  }
  const bool isShort =
      given.analyticExpansionMaxCostOverride && length < 2.0 * base::kPi * radius();
  const bool isRefused = context_.distro != Distro::Humble && isLeft && !isShort;
  return isRefused ? std::nullopt : std::optional(std::move(path));
}

/// The path including the poses along the primitives.
Path LatticeSearch::pathTo(int index) const {
  std::vector<const Node*> chain;
  for (int at = index; at >= 0; at = nodes_[static_cast<std::size_t>(at)].parent) {
    chain.push_back(&nodes_[static_cast<std::size_t>(at)]);
  }
  Path path = {chain.back()->pose};
  for (std::size_t i = chain.size() - 1; i-- > 0;) {
    addPoses(*chain[i + 1], *chain[i], path);
  }
  return path;
}

void LatticeSearch::addPoses(const Node& parent, const Node& node, Path& path) const {
  const std::vector<Pose2>& poses = node.primitive->poses;
  for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
    const double heading =
        node.isBackward ? base::wrapToPi(poses[i].heading + base::kPi) : poses[i].heading;
    path.push_back(
        {parent.pose.position + poses[i].position / context_.costmap.resolution(), heading});
  }
  path.push_back(node.pose);
}

}  // namespace sim2d::nav2
