#pragma once

#include <vector>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/HybridEstimates.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"

namespace sim2d::nav2 {

/// nav2_smac_planner::SmacPlannerLattice: A* over the motion primitives of a file. Their lengths
/// count in cells of the costmap, whatever resolution the file was made for.
class SmacLatticePlanner : public GlobalPlanner {
 public:
  /// `parameters.lattice` must be there.
  SmacLatticePlanner(const SmacLatticeParameters& parameters, Distro distro);

  PlanResult plan(const PlanRequest& request) override;

 private:
  PlanResult planIn(Costmap costmap, const PlanRequest& request);

  SmacLatticeParameters parameters_;
  Distro distro_;
  ObstacleDistance obstacles_;
};

}  // namespace sim2d::nav2
