#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"
#include "sim2d/nav/nav2/global/ShortestCurve.h"
#include "sim2d/nav/nav2/global/SmacCommon.h"

namespace sim2d::nav2 {

/// A motion primitive of Smac Hybrid-A* (nav2_smac_planner, node_hybrid.cpp). Lengths in cells,
/// headings in bins of 2 pi / `angle_quantization_bins`.
struct HybridStep {
  double dx = 0.0, dy = 0.0;  // [cells], in the frame of the start pose
  int bins = 0;               // heading change, counter-clockwise
  ShortestCurve::Turn turn = ShortestCurve::Turn::Straight;
  bool isBackward = false;
  double length = 0.0;  // L [cells]
};

/// The motion primitives of a car and their costs.
class HybridMotion {
 public:
  HybridMotion(const SmacHybridParameters& parameters, double cellSize, Distro distro);

  CarMotion car() const { return car_; }
  double turningRadius() const { return radius_; }  // R [cells], at least 1
  int bins() const { return bins_; }
  double binSize() const { return binSize_; }  // [rad]
  bool isQuadratic() const { return isQuadratic_; }
  int nearestBin(double heading) const;
  int wrappedBin(int bin) const { return ((bin % bins_) + bins_) % bins_; }
  /// Straight, left, right, the same in reverse for Reeds-Shepp, then wider turns.
  const std::vector<HybridStep>& steps() const { return steps_; }
  /// Displacement of a step from a heading, world axes [cells].
  const Vec2& offset(std::size_t step, int bin) const {
    return offsets_[step * static_cast<std::size_t>(bins_) + static_cast<std::size_t>(bin)];
  }
  /// Cost of a step into a cell after another step; `before` is null at the start.
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

/// nav2_smac_planner::SmacPlannerHybrid: A* over poses, for cars that drive forward (DUBIN) or
/// forward and in reverse (REEDS_SHEPP). Before Main, start and goal are moved to the centres of
/// their cells; their headings are always rounded to the nearest bin.
class SmacHybridPlanner : public GlobalPlanner {
 public:
  SmacHybridPlanner(const SmacHybridParameters& parameters, Distro distro);

  PlanResult plan(const PlanRequest& request) override;

 private:
  DistanceHeuristic& curvesFor(const HybridMotion& motion, const Costmap& costmap);
  PlanResult planIn(const Costmap& costmap, const PlanRequest& request);

  SmacHybridParameters parameters_;
  Distro distro_;
  ObstacleHeuristic obstacles_;
  std::optional<DistanceHeuristic> curves_;  // for the radius and side below
  double curveRadius_ = 0.0;                 // [cells]
  int curveSide_ = 0;                        // [cells]
};

}  // namespace sim2d::nav2
