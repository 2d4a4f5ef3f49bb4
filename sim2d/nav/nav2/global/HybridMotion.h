#pragma once

#include <cstdint>
#include <vector>

#include "sim2d/nav/nav2/global/PlannerParameters.h"
#include "sim2d/nav/nav2/global/ShortestCurve.h"

/// Steps of Smac Hybrid-A* (nav2_smac_planner, node_hybrid.cpp). Lengths in cells, headings in bins
/// of 2 pi / `angle_quantization_bins`.
namespace sim2d::nav2 {

struct HybridStep {
  double dx = 0.0, dy = 0.0;  // [cells], in the frame of the pose it starts at
  int bins = 0;               // turn, counter-clockwise
  ShortestCurve::Turn turn = ShortestCurve::Turn::Straight;
  bool isBackward = false;
  double length = 0.0;  // L [cells]
};

/// What the car of a request can do and what it costs.
class HybridMotion {
 public:
  HybridMotion(const SmacHybridParameters& parameters, double cellSize, Distro distro);

  CarMotion car() const { return car_; }
  double turningRadius() const { return radius_; }  // R [cells], at least one
  int bins() const { return bins_; }
  double binSize() const { return binSize_; }  // [rad]
  int nearestBin(double heading) const;
  int wrappedBin(int bin) const { return ((bin % bins_) + bins_) % bins_; }
  /// Straight, left, right, then the same backward for Reeds-Shepp, then gentler turns.
  const std::vector<HybridStep>& steps() const { return steps_; }
  /// Of a step from a heading, world axes [cells].
  const Vec2& offset(std::size_t step, int bin) const {
    return offsets_[step * static_cast<std::size_t>(bins_) + static_cast<std::size_t>(bin)];
  }
  /// Cost of a step into a cell after another step; `before` null: out of the start.
  double cost(const HybridStep* before, const HybridStep& step, std::uint8_t cellCost) const;

 private:
  void addTurn(int bins, double radius, double length);

  CarMotion car_;
  int bins_;
  double binSize_, radius_;
  double nonStraightPenalty_, changePenalty_, reversePenalty_, costPenalty_, reward_;
  bool isQuadratic_;
  std::vector<HybridStep> steps_;
  std::vector<Vec2> offsets_;
};

}  // namespace sim2d::nav2
