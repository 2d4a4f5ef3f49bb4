#pragma once

#include "bt/robot/Nav2Files.h"
#include "sim2d/nav/Planner.h"

namespace bt {

/// The planner `nav2`: a user's own nav2_params.yaml and navigator tree, without ROS. In each step
/// the costmaps take the scan in, the tree is ticked once, then the servers do what is due.
///
/// A goal of the scenario is a new run of the tree: the one before is halted. After SUCCESS or
/// FAILURE the tree stands still until the next goal.
void addNav2(sim2d::PlannerRegistry& to, const Nav2Folders& shipped);

}  // namespace bt
