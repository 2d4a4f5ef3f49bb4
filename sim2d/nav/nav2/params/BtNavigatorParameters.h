#pragma once

#include <string>
#include <vector>

#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

namespace sim2d::nav2 {

/// Keys of bt_navigator that have an effect in this program.
struct BtNavigatorParameters {
  std::string defaultNavToPoseBtXml;        // path of the tree; empty: Nav2's default
  std::string defaultNavThroughPosesBtXml;  // the same, for several goals
  double goalReachedTol = 0.25;             // [m], used by the node GoalReached
  std::string goalBlackboardId = "goal", goalsBlackboardId = "goals";
  std::string waypointStatusesBlackboardId = "waypoint_statuses";  // since Kilted
};
const std::vector<Nav2Key<BtNavigatorParameters>>& btNavigatorKeys();
const std::vector<IgnoredKey>& ignoredBtNavigatorKeys();

/// The reason why a ROS node of this name has no effect ("amcl"), or null for other names.
const char* ignoredNodeReason(const std::string& node);

}  // namespace sim2d::nav2
