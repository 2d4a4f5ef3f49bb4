#include "sim2d/nav/nav2/global/HybridSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"
#include "sim2d/nav/nav2/global/SmacCommon.h"

namespace sim2d::nav2 {
namespace {

using StepTurn = ShortestCurve::Turn;

/// Bins of the sharpest turn whose chord leaves the cell: 2 asin(sqrt 2 / (2 R)), rounded up.
int sharpestTurn(double radius, double binSize) {
  const double angle = 2.0 * (0.5 * base::kPi - base::acos(std::sqrt(2.0) / (2.0 * radius)));
  return std::max(1, static_cast<int>(std::ceil(angle / binSize)));
}

}  // namespace

HybridMotion::HybridMotion(const SmacHybridParameters& parameters, double cellSize, Distro distro)
    : car_(parameters.motionModelForSearch == "REEDS_SHEPP" ? CarMotion::ReedsShepp
                                                            : CarMotion::Dubins),
      bins_(parameters.angleQuantizationBins),
      binSize_(2.0 * base::kPi / bins_),
      radius_(std::max(1.0, parameters.minimumTurningRadius / cellSize)),
      nonStraightPenalty_(parameters.nonStraightPenalty),
      changePenalty_(parameters.changePenalty),
      reversePenalty_(parameters.reversePenalty),
      costPenalty_(parameters.costPenalty),
      reward_(1.0 - parameters.retrospectivePenalty),
      isQuadratic_(distro != Distro::Humble && parameters.useQuadraticCostPenalty) {
  const int sharpest = sharpestTurn(radius_, binSize_);
  const double angle = sharpest * binSize_;
  const double chord = 2.0 * radius_ * base::sin(0.5 * angle);
  steps_.push_back({chord, 0.0, 0, StepTurn::Straight, false, chord});
  addTurn(sharpest, radius_, distro == Distro::Humble ? chord : radius_ * angle);
  if (distro != Distro::Humble && parameters.allowPrimitiveInterpolation) {
    for (int bins = 1; bins < sharpest; ++bins) {
      const double radius = chord / (2.0 * base::sin(0.5 * bins * binSize_));
      addTurn(bins, radius, radius * bins * binSize_);
    }
  }
  if (car_ == CarMotion::ReedsShepp) {
    const std::vector<HybridStep> forward = steps_;
    for (HybridStep step : forward) {
      step.dx = -step.dx;
      step.bins = -step.bins;
      step.isBackward = true;
      steps_.push_back(step);
    }
  }
  for (const HybridStep& step : steps_) {
    for (int bin = 0; bin < bins_; ++bin) {
      const base::SinCos at = base::sinCos(bin * binSize_);
      offsets_.emplace_back(step.dx * at.cos - step.dy * at.sin,
                            step.dx * at.sin + step.dy * at.cos);
    }
  }
}

void HybridMotion::addTurn(int bins, double radius, double length) {
  const double angle = bins * binSize_;
  const double dx = radius * base::sin(angle), dy = radius * (1.0 - base::cos(angle));
  steps_.push_back({dx, dy, bins, StepTurn::Left, false, length});
  steps_.push_back({dx, -dy, -bins, StepTurn::Right, false, length});
}

int HybridMotion::nearestBin(double heading) const {
  return wrappedBin(static_cast<int>(std::round(base::wrapToPi(heading) / binSize_)));
}

double HybridMotion::cost(const HybridStep* before, const HybridStep& step,
                          std::uint8_t cellCost) const {
  const double share = cellCost / kSmacMaxCost;
  double cost = step.length * (reward_ + costPenalty_ * (isQuadratic_ ? share * share : share));
  if (before != nullptr && step.turn != StepTurn::Straight) {
    const bool isSameWay = before->turn == step.turn && before->isBackward == step.isBackward;
    cost *= isSameWay ? nonStraightPenalty_ : nonStraightPenalty_ + changePenalty_;
  }
  return step.isBackward ? cost * reversePenalty_ : cost;
}

namespace {

constexpr double kNewCell =
    1.4142135623730951;  // [cells] a move of this length always leaves the cell
constexpr int kAncestors = 8, kAncestorStride = 5;
constexpr std::size_t kMaxNodes = 5000000;
constexpr std::size_t kMaxSlots = 100000000;  // headings of visited cells

}  // namespace

HybridSearch::HybridSearch(const Context& context)
    : context_(context), blockOf_(context.costmap.costs().size(), -1) {}

bool HybridSearch::isInside(const Vec2& place) const {
  return place.x() >= 0.0 && place.y() >= 0.0 && place.x() < context_.costmap.width() &&
         place.y() < context_.costmap.height();
}

std::optional<std::uint8_t> HybridSearch::costAt(const Pose2& pose) const {
  if (!isInside(pose.position)) {
    return std::nullopt;
  }
  const Costmap& costmap = context_.costmap;
  const bool allowUnknown = context_.parameters.allowUnknown;
  const std::uint8_t cost =
      costmap.at({static_cast<int>(pose.position.x()), static_cast<int>(pose.position.y())});
  if (!isSmacFree(cost, allowUnknown)) {
    return std::nullopt;
  }
  const PlanRequest& request = context_.request;
  const double safe = request.circumscribedCost;
  if (request.footprint.empty() || (safe > 0.0 && cost < safe)) {
    return cost;
  }
  const Pose2 inWorld{costmap.origin() + costmap.resolution() * pose.position, pose.heading};
  const std::uint8_t edges = footprintCost(costmap, request.footprint, inWorld);
  return isEdgeCollision(edges, allowUnknown) ? std::nullopt : std::optional(cost);
}

int HybridSearch::nodeAt(const Vec2& place, int bin) {
  const Cell cell{static_cast<int>(place.x()), static_cast<int>(place.y())};
  const auto bins = static_cast<std::size_t>(context_.motion.bins());
  std::int32_t& block = blockOf_[context_.costmap.indexOf(cell)];
  if (block < 0) {
    block = static_cast<std::int32_t>(slots_.size() / bins);
    slots_.resize(slots_.size() + bins, -1);
  }
  std::int32_t& slot =
      slots_[static_cast<std::size_t>(block) * bins + static_cast<std::size_t>(bin)];
  if (slot < 0) {
    slot = static_cast<std::int32_t>(nodes_.size());
    nodes_.emplace_back();
    nodes_.back().g = std::numeric_limits<double>::max();
    nodes_.back().bin = bin;
  }
  return slot;
}

double HybridSearch::estimate(const Node& node) {
  const Vec2& place = node.pose.position;
  const double round =
      context_.obstacles.from({static_cast<int>(place.x()), static_cast<int>(place.y())});
  double curve = std::numeric_limits<double>::max();
  for (const Pose2& goal : goals_) {
    const int bin = context_.motion.wrappedBin(node.bin - context_.motion.nearestBin(goal.heading));
    double length = context_.curves.from(goal.toLocal(place), bin);
    if (length <= 0.0 && round <= 0.0) {
      length =
          shortestCurve(context_.motion.car(), node.pose, goal, context_.motion.turningRadius())
              .length();
    }
    curve = std::min(curve, length);
  }
  return std::max(round, curve);
}

void HybridSearch::begin(const Pose2& start, const std::vector<Pose2>& goals) {
  goals_ = goals;
  for (const Pose2& goal : goals) {
    goalNodes_.push_back(nodeAt(goal.position, context_.motion.nearestBin(goal.heading)));
  }
  const int bin = context_.motion.nearestBin(start.heading);
  const int first = nodeAt(start.position, bin);
  Node& root = nodes_[static_cast<std::size_t>(first)];
  root.pose = {start.position, base::wrapToPi(bin * context_.motion.binSize())};
  root.g = 0.0;
  open_.push(0.0, static_cast<std::size_t>(first));
}

/// The path to a goal by analytic expansion, or if the node is a goal.
std::optional<Path> HybridSearch::connectToGoal(int index) {
  if (std::optional<Path> whole = tryAnalyticExpansion(index)) {
    return whole;
  }
  const bool isGoal = std::find(goalNodes_.begin(), goalNodes_.end(), index) != goalNodes_.end();
  return isGoal ? std::optional(pathTo(index)) : std::nullopt;
}

PlanResult HybridSearch::find(const Pose2& start, const std::vector<Pose2>& goals) {
  const SmacHybridParameters& given = context_.parameters;
  const SmacLimits limits = smacLimits(given, given.maxPlanningTime, kSmacHybridPerSecond);
  const double tolerance = given.tolerance / context_.costmap.resolution();
  begin(start, goals);
  PlanResult result;
  int nearGoal = 0;
  while (!open_.isEmpty() && result.iterations < limits.most) {
    if (nodes_.size() > kMaxNodes || slots_.size() > kMaxSlots) {
      result.error = PlanError::Timeout;
      return result;
    }
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
    if (auto whole = connectToGoal(index)) {
      result.path = *std::move(whole);
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
    result.error = result.iterations < limits.most ? PlanError::NoValidPath : PlanError::Timeout;
  }
  return result;
}

void HybridSearch::expand(int index) {
  for (std::size_t step = 0; step < context_.motion.steps().size(); ++step) {
    applyStep(index, step);
  }
}

/// Applies a step to a node and updates the next node if the new cost is lower.
void HybridSearch::applyStep(int from, std::size_t step) {
  const HybridMotion& motion = context_.motion;
  const Node node = nodes_[static_cast<std::size_t>(from)];
  const Vec2 place = node.pose.position + motion.offset(step, node.bin);
  if (!isInside(place)) {
    return;
  }
  const HybridStep& taken = motion.steps()[step];
  const int bin = motion.wrappedBin(node.bin + taken.bins);
  const int index = nodeAt(place, bin);
  if (nodes_[static_cast<std::size_t>(index)].isVisited) {
    return;
  }
  const Pose2 pose{place, base::wrapToPi(bin * motion.binSize())};
  const auto cost = costAt(pose);
  if (!cost) {
    return;
  }
  const HybridStep* before =
      node.step < 0 ? nullptr : &motion.steps()[static_cast<std::size_t>(node.step)];
  const double g = node.g + motion.cost(before, taken, *cost);
  Node& next = nodes_[static_cast<std::size_t>(index)];
  if (g < next.g) {
    next.pose = pose;
    next.g = g;
    next.step = static_cast<int>(step);
    next.parent = from;
    next.cost = *cost;
    const double toGo = estimate(next);
    nearest_.offer(toGo, static_cast<std::size_t>(index));
    open_.push(g + toGo, static_cast<std::size_t>(index));
  }
}

/// Analytic expansion: tries a curve to the goal at intervals that decrease near the goal, from the
/// earliest possible ancestor.
std::optional<Path> HybridSearch::tryAnalyticExpansion(int index) {
  const Node& node = nodes_[static_cast<std::size_t>(index)];
  const double ratio = context_.parameters.analyticExpansionRatio;
  expansion_.closest = std::min(expansion_.closest, static_cast<int>(estimate(node)));
  const int desired =
      std::max(static_cast<int>(expansion_.closest / ratio), static_cast<int>(std::ceil(ratio)));
  expansion_.due = std::min(expansion_.due, desired);
  if (expansion_.due-- > 0) {
    return std::nullopt;
  }
  expansion_.due = desired - 1;
  const Pose2* goal = nullptr;
  std::optional<Path> curve = shortestToGoals(node, goal);
  if (!curve) {
    return std::nullopt;
  }
  const Node* from = &node;
  for (int i = 0; i < kAncestors; ++i) {
    const Node* ancestor = ancestorOf(*from);
    auto longer = ancestor == nullptr ? std::nullopt : analyticExpansionFrom(*ancestor, *goal);
    if (!longer) {
      break;
    }
    curve = std::move(longer);
    from = ancestor;
  }
  Path path = pathTo(static_cast<int>(from - nodes_.data()));
  path.insert(path.end(), curve->begin(), curve->end());
  return path;
}

/// Tries every coarse-th heading of the goal first, and all headings if one of these is reachable.
std::optional<Path> HybridSearch::shortestToGoals(const Node& node, const Pose2*& goal) const {
  const auto coarse =
      static_cast<std::size_t>(std::max(1, context_.parameters.coarseSearchResolution));
  std::optional<Path> shortest;
  double least = std::numeric_limits<double>::max();
  for (const bool isCoarse : {true, false}) {
    for (std::size_t i = 0; i < goals_.size() && (isCoarse || shortest); ++i) {
      if ((i % coarse == 0) != isCoarse) {
        continue;
      }
      const double length = curveLength(node, goals_[i]);
      auto curve = length < least ? analyticExpansionFrom(node, goals_[i]) : std::nullopt;
      if (curve) {
        least = length;
        goal = &goals_[i];
        shortest = std::move(curve);
      }
    }
  }
  return shortest;
}

double HybridSearch::curveLength(const Node& node, const Pose2& goal) const {
  return shortestCurve(context_.motion.car(), node.pose, goal, context_.motion.turningRadius())
      .length();
}

const HybridSearch::Node* HybridSearch::ancestorOf(const Node& node) const {
  const Node* ancestor = &node;
  for (int i = 0; i < kAncestorStride; ++i) {
    if (ancestor->parent < 0) {
      return nullptr;
    }
    ancestor = &nodes_[static_cast<std::size_t>(ancestor->parent)];
  }
  return ancestor;
}

/// The poses of a curve after its start; nullopt if its length is out of range, it collides or its
/// cost is too high.
std::optional<Path> HybridSearch::analyticExpansionFrom(const Node& node, const Pose2& goal) const {
  const ShortestCurve curve =
      shortestCurve(context_.motion.car(), node.pose, goal, context_.motion.turningRadius());
  const double length = curve.length();
  const double most =
      context_.parameters.analyticExpansionMaxLength / context_.costmap.resolution();
  if (length > most || length < kNewCell) {
    return std::nullopt;
  }
  const int pieces = static_cast<int>(length / kNewCell);
  Path path;
  std::vector<std::uint8_t> costs;
  for (int i = 1; i <= pieces; ++i) {
    path.push_back(i < pieces ? curve.at(length * i / pieces) : goal);
    const auto cost = costAt(path.back());
    if (!cost) {
      return std::nullopt;
    }
    costs.push_back(*cost);
  }
  return isTooCostly(costs, length) ? std::nullopt : std::optional(std::move(path));
}

/// Whether a curve leaves cells above the maximum cost in a direction other than towards the goal.
bool HybridSearch::isTooCostly(const std::vector<std::uint8_t>& costs, double length) const {
  const SmacHybridParameters& given = context_.parameters;
  if (context_.distro == Distro::Humble) {
    return false;
  }
  const auto isCheap = [&](std::uint8_t cost) { return cost <= given.analyticExpansionMaxCost; };
  const auto lastCheap = std::find_if(costs.rbegin(), costs.rend(), isCheap);
  if (std::all_of(lastCheap, costs.rend(), isCheap)) {
    return false;
  }
  const double circle = 2.0 * base::kPi * context_.motion.turningRadius();
  return !(given.analyticExpansionMaxCostOverride && length < circle);
}

Path HybridSearch::pathTo(int index) const {
  Path path;
  for (int at = index; at >= 0; at = nodes_[static_cast<std::size_t>(at)].parent) {
    path.push_back(nodes_[static_cast<std::size_t>(at)].pose);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace sim2d::nav2
