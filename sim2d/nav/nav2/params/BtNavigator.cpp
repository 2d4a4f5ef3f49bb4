#include "sim2d/nav/nav2/params/BtNavigator.h"

#include <algorithm>
#include <array>

namespace sim2d::nav2 {

const std::vector<Nav2Key<BtNavigatorParameters>>& btNavigatorKeys() {
  using P = BtNavigatorParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"default_nav_to_pose_bt_xml", &P::defaultNavToPoseBtXml, "",
       "File of the navigator's tree; Nav2's own when it is empty"},
      {"default_nav_through_poses_bt_xml", &P::defaultNavThroughPosesBtXml, "",
       "File of the tree for several goals; Nav2's own when it is empty"},
      {"goal_reached_tol", &P::goalReachedTol, "m", "Distance within which GoalReached says yes"},
      {"goal_blackboard_id", &P::goalBlackboardId, "", "Entry of the blackboard with the goal"},
      {"goals_blackboard_id", &P::goalsBlackboardId, "", "Entry of the blackboard with the goals"},
      {"waypoint_statuses_blackboard_id", &P::waypointStatusesBlackboardId, "",
       "Entry of the blackboard with what has become of each goal", kSinceKilted}};
  return kKeys;
}

const std::vector<IdleKey>& idleBtNavigatorKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"bt_loop_duration", "the tree is ticked once per step"},
      {"default_server_timeout", "servers answer immediately here"},
      {"default_cancel_timeout", "servers answer immediately here", kSinceJazzy},
      {"wait_for_service_timeout", "servers answer immediately here"},
      {"action_server_result_timeout", "results do not get lost here", kJazzy},
      {"filter_duration", "speeds are smoothed over 0.3 s", kSinceKilted},
      {"navigators", "the navigator to a pose drives", kSinceJazzy},
      {"navigate_to_pose.", "the navigator to a pose drives"},
      {"navigate_through_poses.", "robots with several goals are driven by it"},
      {"navigate_through_pose.", "goals are driven to one by one here"},
      {"plugin_lib_names", "all nodes of Nav2 are there"},
      {"path_blackboard_id", "trees name their paths themselves"},
      {"global_frame", "goals are in the frame of the global costmap"},
      {"robot_base_frame", "the base frames of a robot coincide here"},
      {"odom_topic", "no topics here"},
      {"odometry_topic", "no topics here"},
      {"transform_tolerance", "no frames here"},
      {"error_code_names", "trees name their error codes themselves", kJazzy},
      {"error_code_name_prefixes", "trees name their error codes themselves", kSinceKilted},
      {"bt_search_directories", "trees include files by path", kSinceLyrical},
      {"bt_log_idle_transitions", "no topics here", kSinceLyrical},
      {"allow_navigator_preemption", "there is one navigator here", kSinceLyrical},
      {"always_reload_bt_xml", "the tree is read once"},
      {"always_reload_bt", "the tree is read once"},
      {"enable_groot_monitoring", "Groot cannot look on here"},
      {"groot_zmq_publisher_port", "Groot cannot look on here"},
      {"groot_zmq_server_port", "Groot cannot look on here"},
      {"enable_groot2_monitoring", "Groot cannot look on here"},
      {"groot2_server_port", "Groot cannot look on here"}};
  return kKeys;
}

const char* idleNode(const std::string& node) {
  static constexpr std::array<IdleKey, 21> kNodes = {
      {{"amcl", "the scenario's `localization` takes its place"},
       {"amcl_map_client", "the scenario's `localization` takes its place"},
       {"amcl_rclcpp_node", "the scenario's `localization` takes its place"},
       {"map_server", "the scenario says which map"},
       {"map_saver", "maps are not saved"},
       {"slam_toolbox", "the map is known"},
       {"lifecycle_manager", "everything runs from the start"},
       {"lifecycle_manager_navigation", "everything runs from the start"},
       {"lifecycle_manager_localization", "everything runs from the start"},
       {"robot_state_publisher", "no frames here"},
       {"loopback_simulator", "this is the simulator"},
       {"keepout_filter_mask_server", "it has no mask file (yaml_filename)"},
       {"speed_filter_mask_server", "it has no mask file (yaml_filename)"},
       {"filter_mask_server", "it has no mask file (yaml_filename)"},
       {"costmap_filter_info_server", "it has no topic (filter_info_topic)"},
       {"keepout_costmap_filter_info_server", "it has no topic (filter_info_topic)"},
       {"speed_costmap_filter_info_server", "it has no topic (filter_info_topic)"},
       {"bt_navigator_rclcpp_node", "a node of the machinery"},
       {"bt_navigator_navigate_to_pose_rclcpp_node", "a node of the machinery"},
       {"bt_navigator_navigate_through_poses_rclcpp_node", "a node of the machinery"},
       {"collision_detector", "it only reports"}}};
  const auto* const found = std::find_if(kNodes.begin(), kNodes.end(),
                                         [&](const IdleKey& each) { return node == each.name; });
  if (found != kNodes.end()) {
    return found->why;
  }
  const std::string end = "_rclcpp_node";
  const bool isMachinery =
      node.size() > end.size() && node.compare(node.size() - end.size(), end.size(), end) == 0;
  return isMachinery ? "a node of the machinery" : nullptr;
}

}  // namespace sim2d::nav2
