#include "sim2d/nav/nav2/global/SmacHybridPlanner.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/global/SmacPoseSearch.h"

namespace sim2d::nav2 {
namespace {

using StepTurn = ShortestCurve::Turn;

/// Bins of the sharpest turn whose chord leaves the cell: 2 asin(sqrt 2 / (2 R)), rounded up.
int sharpestTurn(double radius, double binSize) {
  const double angle = 2.0 * (0.5 * base::kPi - base::acos(std::sqrt(2.0) / (2.0 * radius)));
  return std::max(1, static_cast<int>(std::ceil(angle / binSize)));
}

CarMotion carOf(const SmacHybridParameters& parameters) {
  return parameters.motionModelForSearch == "REEDS_SHEPP" ? CarMotion::ReedsShepp
                                                          : CarMotion::Dubins;
}

}  // namespace

HybridMotion::HybridMotion(const SmacHybridParameters& parameters, double cellSize, Distro distro)
    : car_(carOf(parameters)),
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

class HybridSearch : public SmacPoseSearch {
 public:
  HybridSearch(const Setup& setup, const HybridMotion& motion, DistanceHeuristic& curves)
      : SmacPoseSearch(setup), motion_(motion), curves_(curves) {}

 private:
  int nearestHeading(double heading) const override { return motion_.nearestBin(heading); }
  double headingOf(int index) const override { return base::wrapToPi(index * motion_.binSize()); }
  double curveEstimate(const Node& node, const Pose2& goal, double round) override {
    const int bin = motion_.wrappedBin(node.heading - motion_.nearestBin(goal.heading));
    const double length = curves_.from(goal.toLocal(node.pose.position), bin);
    return length <= 0.0 && round <= 0.0 ? curveLength(node, goal) : length;
  }
  void expand(int index) override {
    for (std::size_t step = 0; step < motion_.steps().size(); ++step) {
      applyStep(index, step);
    }
  }

  /// Applies a step to a node and updates the next node if the new cost is lower.
  void applyStep(int from, std::size_t step) {
    const Node node = nodeWith(from);
    const HybridStep& taken = motion_.steps()[step];
    Node next;
    next.heading = motion_.wrappedBin(node.heading + taken.bins);
    next.pose.position = node.pose.position + motion_.offset(step, node.heading);
    const int index = unvisitedNode(next.pose.position, next.heading);
    if (index < 0) {
      return;
    }
    next.pose.heading = headingOf(next.heading);
    const auto cost = costAt(next.pose);
    if (!cost) {
      return;
    }
    const HybridStep* before =
        node.step < 0 ? nullptr : &motion_.steps()[static_cast<std::size_t>(node.step)];
    next.g = node.g + motion_.cost(before, taken, *cost);
    next.step = static_cast<int>(step);
    next.parent = from;
    offer(index, next);
  }

  const HybridMotion& motion_;
  DistanceHeuristic& curves_;
};

}  // namespace

SmacHybridPlanner::SmacHybridPlanner(const SmacHybridParameters& parameters, Distro distro)
    : parameters_(parameters), distro_(distro) {}

PlanResult SmacHybridPlanner::plan(const PlanRequest& request) {
  const int factor = parameters_.downsampleCostmap ? parameters_.downsamplingFactor : 1;
  const Costmap costmap = downsampled(request.costmap, factor, false);
  const double radius = std::max(parameters_.minimumTurningRadius, costmap.resolution());
  return planOverPoses(costmap, request, parameters_, {carOf(parameters_), radius},
                       [&] { return planIn(costmap, request); });
}

DistanceHeuristic& SmacHybridPlanner::curvesFor(const HybridMotion& motion,
                                                const Costmap& costmap) {
  constexpr double kMaxSide = 2000.0;  // [cells]
  const double wanted = std::fmin(parameters_.lookupTableSize / costmap.resolution(), kMaxSide);
  const int side = static_cast<int>(wanted) | 1;  // odd
  if (!curves_ || curveRadius_ != motion.turningRadius() || curveSide_ != side) {
    curves_.emplace(motion.car(), motion.turningRadius(), motion.bins(), side);
    curveRadius_ = motion.turningRadius();
    curveSide_ = side;
  }
  return *curves_;
}

/// Plans a path in cell coordinates.
PlanResult SmacHybridPlanner::planIn(const Costmap& costmap, const PlanRequest& request) {
  const HybridMotion motion(parameters_, costmap.resolution(), distro_);
  ObstacleHeuristic::Settings heuristic;
  heuristic.costPenalty = parameters_.costPenalty;
  heuristic.isQuadratic = motion.isQuadratic();
  heuristic.allowUnknown = parameters_.allowUnknown;
  heuristic.isDownsampled = parameters_.downsampleObstacleHeuristic || distro_ == Distro::Humble;
  const SmacPoseSearch::Setup setup{SmacPoseSearch::Kind::Hybrid,
                                    parameters_,
                                    distro_,
                                    costmap,
                                    request,
                                    obstacles_,
                                    motion.car(),
                                    motion.turningRadius(),
                                    motion.bins(),
                                    heuristic,
                                    parameters_.coarseSearchResolution};
  const bool isCentred = distro_ < Distro::Lyrical;
  return HybridSearch(setup, motion, curvesFor(motion, costmap))
      .plan(inCells(costmap, request.start, isCentred), inCells(costmap, request.goal, isCentred));
}

}  // namespace sim2d::nav2
