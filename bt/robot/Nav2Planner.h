#pragma once

#include "bt/robot/Nav2Files.h"
#include "sim2d/nav/Planner.h"

namespace bt {

/// The planner `nav2`: the user's nav2_params.yaml and navigator tree, without ROS. In each step
/// the costmaps process the scan, the tree is ticked once, then the servers run.
///
/// A new goal of the scenario halts the current run of the tree and starts a new one. A run ends
/// with SUCCESS or FAILURE of the tree (`Planner::takeNavigationResult`), regardless of the robot's
/// position; a route through several goals ends as a whole.
void addNav2(sim2d::PlannerRegistry& to, const Nav2Folders& shipped);

}  // namespace bt
