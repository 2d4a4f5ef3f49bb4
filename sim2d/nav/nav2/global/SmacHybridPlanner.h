#pragma once

#include <optional>
#include <vector>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/HybridSearch.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"
#include "sim2d/nav/nav2/global/SmacCommon.h"

namespace sim2d::nav2 {

/// nav2_smac_planner::SmacPlannerHybrid: A* over poses, for cars that drive forward (DUBIN) or
/// forward and in reverse (REEDS_SHEPP). Before Main, start and goal are moved to the centres of
/// their cells; their headings are always rounded to the nearest bin.
class SmacHybridPlanner : public GlobalPlanner {
 public:
  SmacHybridPlanner(const SmacHybridParameters& parameters, Distro distro);

  PlanResult plan(const PlanRequest& request) override;

 private:
  Pose2 inCells(const Costmap& costmap, const Pose2& pose) const;
  std::vector<Pose2> goalsAt(const HybridMotion& motion, const Pose2& goal) const;
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
