#pragma once

#include "bt/robot/Nav2Files.h"
#include "sim2d/nav/Planner.h"

namespace bt {

/// The planner `nav2`: a user's own nav2_params.yaml and navigator tree, without ROS. In each step
/// the costmaps take the scan in, the tree is ticked once, then the servers do what is due.
///
/// A goal of the scenario is a new run of the tree: the one before is halted. It ends with SUCCESS
/// or FAILURE of the tree (`Planner::takeEnd`), wherever the robot is then; a route ends as a
/// whole.
void addNav2(sim2d::PlannerRegistry& to, const Nav2Folders& shipped);

}  // namespace bt
