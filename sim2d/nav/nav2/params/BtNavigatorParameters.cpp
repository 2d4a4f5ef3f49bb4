#include "sim2d/nav/nav2/params/BtNavigatorParameters.h"

#include <array>
#include <string_view>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"

namespace sim2d::nav2 {

const std::vector<Nav2Key<BtNavigatorParameters>>& btNavigatorKeys() {
  using P = BtNavigatorParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"default_nav_to_pose_bt_xml", &P::defaultNavToPoseBtXml, "",
       "File of the navigator's tree; empty: Nav2's own"},
      {"default_nav_through_poses_bt_xml", &P::defaultNavThroughPosesBtXml, "",
       "File of the tree for several goals; empty: Nav2's own"},
      {"goal_reached_tol", &P::goalReachedTol, "m", "Distance within which GoalReached succeeds"},
      {"goal_blackboard_id", &P::goalBlackboardId, "", "Blackboard entry with the goal"},
      {"goals_blackboard_id", &P::goalsBlackboardId, "", "Blackboard entry with the goals"},
      {"waypoint_statuses_blackboard_id", &P::waypointStatusesBlackboardId, "",
       "Blackboard entry with the status of each goal", kSinceKilted}};
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredBtNavigatorKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"bt_loop_duration", "the tree is ticked once per time step"},
      {"default_server_timeout", "servers respond immediately"},
      {"default_cancel_timeout", "servers respond immediately", kSinceJazzy},
      {"wait_for_service_timeout", "servers respond immediately"},
      {"filter_duration", "speeds are always smoothed over 0.3 s", kSinceKilted},
      {"navigators", "the navigator NavigateToPose is used", kSinceJazzy},
      {"navigate_to_pose.", "the navigator NavigateToPose is used", kSinceJazzy},
      {"navigate_through_poses.", "robots with several goals use this navigator", kSinceJazzy},
      {"navigate_through_pose.", "the robot drives to goals one by one"},
      {"plugin_lib_names", "all nodes of Nav2 are available"},
      {"path_blackboard_id", "trees define their own path entries"},
      {"global_frame", "goals are in the frame of the global costmap"},
      {"robot_base_frame", "all base frames of a robot are identical"},
      {"odom_topic", "ROS topics are not used"},
      {"odometry_topic", "ROS topics are not used"},
      {"transform_tolerance", "TF is not used"},
      {"error_code_names", "trees define their own error codes", kJazzy},
      {"error_code_name_prefixes", "trees define their own error codes", kSinceKilted},
      {"bt_search_directories", "trees include files by path", kSinceLyrical},
      {"bt_log_idle_transitions", "ROS topics are not used", kSinceLyrical},
      {"allow_navigator_preemption", "this program uses a single navigator", kSinceLyrical},
      {"always_reload_bt_xml", "the tree is read once"},
      {"always_reload_bt", "the tree is read once"},
      {"enable_groot_monitoring", "Groot cannot monitor the tree in this program"},
      {"groot_zmq_publisher_port", "Groot cannot monitor the tree in this program"},
      {"groot_zmq_server_port", "Groot cannot monitor the tree in this program"},
      {"enable_groot2_monitoring", "Groot cannot monitor the tree in this program"},
      {"groot2_server_port", "Groot cannot monitor the tree in this program"}};
  return kKeys;
}

const char* ignoredNodeReason(const std::string& node) {
  static constexpr std::array<IgnoredKey, 24> kNodes = {
      {{"amcl", "the scenario's `localization` replaces it"},
       {"amcl_map_client", "the scenario's `localization` replaces it"},
       {"amcl_rclcpp_node", "the scenario's `localization` replaces it"},
       {"local_costmap_client", "an infrastructure node without effect on the robot"},
       {"global_costmap_client", "an infrastructure node without effect on the robot"},
       {"map_server", "the scenario names the map"},
       {"map_saver", "maps are not saved"},
       {"slam_toolbox", "the map is known"},
       {"lifecycle_manager", "all nodes run from the start"},
       {"lifecycle_manager_navigation", "all nodes run from the start"},
       {"lifecycle_manager_localization", "all nodes run from the start"},
       {"robot_state_publisher", "TF is not used"},
       {"base_footprint_publisher", "TF is not used"},
       {"loopback_simulator", "this program is the simulator"},
       {"keepout_filter_mask_server", "it has no mask file (yaml_filename)"},
       {"speed_filter_mask_server", "it has no mask file (yaml_filename)"},
       {"filter_mask_server", "it has no mask file (yaml_filename)"},
       {"costmap_filter_info_server", "it has no topic (filter_info_topic)"},
       {"keepout_costmap_filter_info_server", "it has no topic (filter_info_topic)"},
       {"speed_costmap_filter_info_server", "it has no topic (filter_info_topic)"},
       {"bt_navigator_rclcpp_node", "an infrastructure node without effect on the robot"},
       {"bt_navigator_navigate_to_pose_rclcpp_node",
        "an infrastructure node without effect on the robot"},
       {"bt_navigator_navigate_through_poses_rclcpp_node",
        "an infrastructure node without effect on the robot"},
       {"collision_detector", "it only reports data"}}};
  if (const IgnoredKey* const found = base::findBy(kNodes, &IgnoredKey::name, node)) {
    return found->why;
  }
  constexpr std::string_view kEnd = "_rclcpp_node";
  const bool isInternalNode = node.size() > kEnd.size() && base::endsWith(node, kEnd);
  return isInternalNode ? "an infrastructure node without effect on the robot" : nullptr;
}

}  // namespace sim2d::nav2
