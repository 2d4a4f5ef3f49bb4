#include "sim2d/nav/nav2/global/HybridMotion.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/global/SmacGrid.h"

namespace sim2d::nav2 {
namespace {

using StepTurn = ShortestCurve::Turn;

/// Bins of the sharpest turn whose chord leads out of the cell: 2 asin(sqrt 2 / (2 R)), rounded up.
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
  const double share = cellCost / kSmacMostCost;
  double cost = step.length * (reward_ + costPenalty_ * (isQuadratic_ ? share * share : share));
  if (before != nullptr && step.turn != StepTurn::Straight) {
    const bool isSameWay = before->turn == step.turn && before->isBackward == step.isBackward;
    cost *= isSameWay ? nonStraightPenalty_ : nonStraightPenalty_ + changePenalty_;
  }
  return step.isBackward ? cost * reversePenalty_ : cost;
}

}  // namespace sim2d::nav2
