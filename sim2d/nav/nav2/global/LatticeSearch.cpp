#include "sim2d/nav/nav2/global/LatticeSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim2d/nav/nav2/costmap/FootprintCost.h"

namespace sim2d::nav2 {
namespace {

constexpr double kLatticeStep =
    1.4142135623730951;              // [cells] a move of this length leaves the cell
constexpr double kOnTheSpot = 1e-4;  // [m]
constexpr double kNoArc = 1e-3;      // [m] of an arc
constexpr std::size_t kMostLatticeNodes = 5000000;

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

LatticeSearch::LatticeSearch(const Setting& setting)
    : setting_(setting),
      slots_(setting.costmap.costs().size() * setting.lattice.headings.size(), -1) {}

CarMotion LatticeSearch::car() const {
  return setting_.parameters.allowReverseExpansion ? CarMotion::ReedsShepp : CarMotion::Dubins;
}

double LatticeSearch::radius() const {
  return setting_.lattice.turningRadius / setting_.costmap.resolution();
}

bool LatticeSearch::isInside(const Vec2& place) const {
  return place.x() >= 0.0 && place.y() >= 0.0 && place.x() < setting_.costmap.width() &&
         place.y() < setting_.costmap.height();
}

std::optional<std::uint8_t> LatticeSearch::costAt(const Pose2& pose) const {
  if (!isInside(pose.position)) {
    return std::nullopt;
  }
  const Costmap& costmap = setting_.costmap;
  const bool allowUnknown = setting_.parameters.allowUnknown;
  const std::uint8_t cost =
      costmap.at({static_cast<int>(pose.position.x()), static_cast<int>(pose.position.y())});
  const PlanRequest& request = setting_.request;
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
  const SmacLatticeParameters& given = setting_.parameters;
  const double length = primitive.length / setting_.costmap.resolution();
  if (before == nullptr) {
    return length;
  }
  const double share = cellCost / kSmacMostCost;
  const bool isQuadratic = setting_.distro >= Distro::Lyrical && given.useQuadraticCostPenalty;
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
  std::int32_t& slot = slots_[setting_.costmap.indexOf(cell) * setting_.lattice.headings.size() +
                              static_cast<std::size_t>(heading)];
  if (slot < 0) {
    slot = static_cast<std::int32_t>(nodes_.size());
    nodes_.emplace_back();
    nodes_.back().g = std::numeric_limits<double>::max();
    nodes_.back().heading = heading;
  }
  return slot;
}

/// The greater of the way around obstacles and the shortest curve to a goal.
double LatticeSearch::estimate(const Node& node) {
  const Vec2& place = node.pose.position;
  const double around =
      setting_.obstacles.from({static_cast<int>(place.x()), static_cast<int>(place.y())});
  double curve = std::numeric_limits<double>::max();
  for (const Pose2& goal : goals_) {
    curve = std::min(curve, shortestCurve(car(), node.pose, goal, radius()).length());
  }
  return std::max(around, curve);
}

PlanResult LatticeSearch::find(const Pose2& start, const std::vector<Pose2>& goals) {
  const SmacLatticeParameters& given = setting_.parameters;
  const SmacLimits limits = smacLimits(given, given.maxPlanningTime, kSmacHybridPerSecond);
  const double tolerance = given.tolerance / setting_.costmap.resolution();
  goals_ = goals;
  for (const Pose2& goal : goals) {
    goalNodes_.push_back(nodeAt(goal.position, setting_.lattice.nearestHeading(goal.heading)));
  }
  const int heading = setting_.lattice.nearestHeading(start.heading);
  const int first = nodeAt(start.position, heading);
  Node& root = nodes_[static_cast<std::size_t>(first)];
  root.pose = {start.position, setting_.lattice.headings[static_cast<std::size_t>(heading)]};
  root.g = 0.0;
  open_.push(0.0, static_cast<std::size_t>(first));
  PlanResult result;
  int nearGoal = 0;
  while (!open_.isEmpty() && result.iterations < limits.most &&
         nodes_.size() <= kMostLatticeNodes) {
    const std::size_t node = open_.pop().node;
    const int index = static_cast<int>(node);
    if (nodes_[node].isVisited) {
      continue;
    }
    if (setting_.request.stop != nullptr && result.iterations % limits.checkEvery == 0) {
      setting_.request.stop->check();
    }
    ++result.iterations;
    nodes_[node].isVisited = true;
    if (auto whole = curveToGoal(index)) {
      result.path = *std::move(whole);
      return result;
    }
    if (std::find(goalNodes_.begin(), goalNodes_.end(), index) != goalNodes_.end()) {
      result.path = pathTo(index);
      return result;
    }
    if (nearest_.estimate < tolerance && ++nearGoal >= limits.mostOnApproach) {
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

/// Forward, and with `allow_reverse_expansion` backward by the primitives of the opposite heading.
void LatticeSearch::expand(int index) {
  const int heading = nodes_[static_cast<std::size_t>(index)].heading;
  const auto go = [&](int from, bool isBackward) {
    for (const LatticePrimitive& primitive :
         setting_.lattice.primitives[static_cast<std::size_t>(from)]) {
      enter(index, primitive, isBackward);
    }
  };
  go(heading, false);
  if (setting_.parameters.allowReverseExpansion) {
    go(setting_.lattice.oppositeOf(heading), true);
  }
}

void LatticeSearch::enter(int from, const LatticePrimitive& primitive, bool isBackward) {
  const Node node = nodes_[static_cast<std::size_t>(from)];
  const Lattice& lattice = setting_.lattice;
  const Vec2 place =
      node.pose.position + primitive.poses.back().position / setting_.costmap.resolution();
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

/// The highest cost along a primitive, looked at about once per cell; none: it collides.
std::optional<double> LatticeSearch::costAlong(const Pose2& from, const LatticePrimitive& primitive,
                                               bool isBackward) const {
  const double side = setting_.costmap.resolution();
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

/// Every now and then, more often near the goal, a curve straight into it.
std::optional<Path> LatticeSearch::curveToGoal(int index) {
  const double ratio = setting_.parameters.analyticExpansionRatio;
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
    auto curve = length < least ? curveFrom(node, goal) : std::nullopt;
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

std::optional<Path> LatticeSearch::curveFrom(const Node& node, const Pose2& goal) const {
  const ShortestCurve curve = shortestCurve(car(), node.pose, goal, radius());
  const double length = curve.length();
  const SmacLatticeParameters& given = setting_.parameters;
  if (length > given.analyticExpansionMaxLength / setting_.costmap.resolution() ||
      length < kLatticeStep) {
    return std::nullopt;
  }
  const int pieces = static_cast<int>(length / kLatticeStep);
  Path path;
  bool wasCheap = false, isLeft = false;  // cells that cost little, then some that do not
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
  const bool isRefused = setting_.distro != Distro::Humble && isLeft && !isShort;
  return isRefused ? std::nullopt : std::optional(std::move(path));
}

/// With the poses along the primitives.
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
        {parent.pose.position + poses[i].position / setting_.costmap.resolution(), heading});
  }
  path.push_back(node.pose);
}

}  // namespace sim2d::nav2
