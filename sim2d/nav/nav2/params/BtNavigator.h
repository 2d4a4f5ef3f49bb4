#pragma once

#include <string>
#include <vector>

#include "sim2d/nav/nav2/Nav2Key.h"

namespace sim2d::nav2 {

/// Keys of bt_navigator that count here.
struct BtNavigatorParameters {
  std::string defaultNavToPoseBtXml;        // path of the tree; empty: Nav2's own
  std::string defaultNavThroughPosesBtXml;  // idem, of robots with several goals
  double goalReachedTol = 0.25;             // [m], of the node GoalReached
  std::string goalBlackboardId = "goal", goalsBlackboardId = "goals";
  std::string waypointStatusesBlackboardId = "waypoint_statuses";  // since Kilted
};
const std::vector<Nav2Key<BtNavigatorParameters>>& btNavigatorKeys();
const std::vector<IdleKey>& idleBtNavigatorKeys();

/// Nodes that files speak to and that are not here, and why: "amcl". Null: not one of them.
const char* idleNode(const std::string& node);

}  // namespace sim2d::nav2
