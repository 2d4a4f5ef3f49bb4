#pragma once

#include <string>
#include <vector>

#include "tests/run/Nav2Set.h"

/// Whole files in the layout of nav2_bringup: every node of a robot, in the spelling and with the
/// keys of each branch, and trees that use further servers.
namespace nav2set {

inline const std::string kAmcl = R"(amcl:
  ros__parameters:
    alpha1: 0.2
    alpha2: 0.2
    base_frame_id: "base_footprint"
    global_frame_id: "map"
    odom_frame_id: "odom"
    laser_model_type: "likelihood_field"
    max_beams: 60
    max_particles: 2000
    min_particles: 500
    robot_model_type: "nav2_amcl::DifferentialMotionModel"
    scan_topic: scan
    set_initial_pose: false
    tf_broadcast: true
    update_min_a: 0.2
    update_min_d: 0.25
)";

inline const std::string kMaps = R"(map_server:
  ros__parameters:
    yaml_filename: ""
map_saver:
  ros__parameters:
    save_map_timeout: 5.0
    free_thresh_default: 0.25
    occupied_thresh_default: 0.65
    map_subscribe_transient_local: true
)";

inline const std::string kCheckers = R"(    progress_checker:
      plugin: "nav2_controller::SimpleProgressChecker"
      required_movement_radius: 0.5
      movement_time_allowance: 10.0
    general_goal_checker:
      plugin: "nav2_controller::SimpleGoalChecker"
      stateful: true
      xy_goal_tolerance: 0.25
      yaw_goal_tolerance: 0.25
)";

inline const std::string kServerRates = R"(    controller_frequency: 20.0
    min_x_velocity_threshold: 0.001
    min_y_velocity_threshold: 0.5
    min_theta_velocity_threshold: 0.001
    failure_tolerance: 0.3
    goal_checker_plugins: ["general_goal_checker"]
    controller_plugins: ["FollowPath"]
)";

/// Both costmaps, with further keys.
inline std::string costmapsWith(const std::string& localMore, const std::string& globalMore) {
  const std::string common = R"(      robot_base_frame: base_link
      robot_radius: 0.35
      resolution: 0.05
      always_send_full_costmap: true
      inflation_layer:
        plugin: "nav2_costmap_2d::InflationLayer"
        cost_scaling_factor: 3.0
        inflation_radius: 0.7
)";
  const std::string scan = R"(        enabled: true
        observation_sources: scan
        scan:
          topic: /scan
          max_obstacle_height: 2.0
          clearing: true
          marking: true
          data_type: "LaserScan"
          raytrace_max_range: 3.0
          raytrace_min_range: 0.0
          obstacle_max_range: 2.5
          obstacle_min_range: 0.0
)";
  return "local_costmap:\n  local_costmap:\n    ros__parameters:\n      update_frequency: 5.0\n"
         "      publish_frequency: 2.0\n      global_frame: odom\n      rolling_window: true\n"
         "      width: 3\n      height: 3\n      plugins: [\"voxel_layer\", "
         "\"inflation_layer\"]\n" +
         common +
         "      voxel_layer:\n        plugin: \"nav2_costmap_2d::VoxelLayer\"\n"
         "        publish_voxel_map: true\n        origin_z: 0.0\n        z_resolution: 0.05\n"
         "        z_voxels: 16\n        max_obstacle_height: 2.0\n        mark_threshold: 0\n" +
         scan + localMore +
         "global_costmap:\n  global_costmap:\n    ros__parameters:\n      update_frequency: 1.0\n"
         "      publish_frequency: 1.0\n      global_frame: map\n      track_unknown_space: true\n"
         "      plugins: [\"static_layer\", \"obstacle_layer\", \"inflation_layer\"]\n" +
         common +
         "      static_layer:\n        plugin: \"nav2_costmap_2d::StaticLayer\"\n"
         "        map_subscribe_transient_local: true\n"
         "      obstacle_layer:\n        plugin: \"nav2_costmap_2d::ObstacleLayer\"\n" +
         scan + globalMore;
}

/// `separator` is that of class names.
inline std::string behaviorsWith(const std::string& separator, const std::string& topics) {
  std::string text = "behavior_server:\n  ros__parameters:\n" + topics +
                     "    cycle_frequency: 10.0\n    behavior_plugins: [\"spin\", \"backup\", "
                     "\"drive_on_heading\", \"assisted_teleop\", \"wait\"]\n";
  for (const auto& [name, type] :
       {std::pair("spin", "Spin"), std::pair("backup", "BackUp"),
        std::pair("drive_on_heading", "DriveOnHeading"), std::pair("wait", "Wait"),
        std::pair("assisted_teleop", "AssistedTeleop")}) {
    text += std::string("    ") + name + ":\n      plugin: \"nav2_behaviors" + separator + type +
            "\"\n";
  }
  return text +
         "    robot_base_frame: base_link\n    transform_tolerance: 0.1\n"
         "    simulate_ahead_time: 2.0\n    max_rotational_vel: 1.0\n"
         "    min_rotational_vel: 0.4\n    rotational_acc_lim: 3.2\n";
}

inline const std::string kTwoCostmaps = R"(    local_costmap_topic: local_costmap/costmap_raw
    global_costmap_topic: global_costmap/costmap_raw
    local_footprint_topic: local_costmap/published_footprint
    global_footprint_topic: global_costmap/published_footprint
    local_frame: odom
    global_frame: map
)";

inline const std::string kNavigators =
    R"(    navigators: ["navigate_to_pose", "navigate_through_poses"]
    navigate_to_pose:
      plugin: "nav2_bt_navigator::NavigateToPoseNavigator"
    navigate_through_poses:
      plugin: "nav2_bt_navigator::NavigateThroughPosesNavigator"
)";

inline std::string navigatorWith(const std::string& more) {
  return "bt_navigator:\n  ros__parameters:\n    global_frame: map\n"
         "    robot_base_frame: base_link\n    odom_topic: /odom\n" +
         more;
}

/// Planner, path smoother and waypoints; further keys of the planner server.
inline std::string serversWith(const std::string& planner, const std::string& plannerMore = {}) {
  return "planner_server:\n  ros__parameters:\n    expected_planner_frequency: 20.0\n" +
         plannerMore + "    planner_plugins: [\"GridBased\"]\n    GridBased:\n      plugin: \"" +
         planner + "\"\n      tolerance: 0.5\n      use_astar: false\n      allow_unknown: true\n" +
         R"(smoother_server:
  ros__parameters:
    smoother_plugins: ["simple_smoother"]
    simple_smoother:
      plugin: "nav2_smoother::SimpleSmoother"
      tolerance: 1.0e-10
      max_its: 1000
      do_refinement: true
waypoint_follower:
  ros__parameters:
    loop_rate: 20
    stop_on_failure: false
    waypoint_task_executor_plugin: "wait_at_waypoint"
    wait_at_waypoint:
      plugin: "nav2_waypoint_follower::WaitAtWaypoint"
      enabled: true
      waypoint_pause_duration: 200
)";
}

inline std::string humbleFile() {
  return kAmcl +
         navigatorWith(
             "    bt_loop_duration: 10\n    default_server_timeout: 20\n"
             "    plugin_lib_names:\n      - nav2_compute_path_to_pose_action_bt_node\n"
             "      - nav2_follow_path_action_bt_node\n      - nav2_spin_action_bt_node\n"
             "      - nav2_recovery_node_bt_node\n") +
         "bt_navigator_navigate_to_pose_rclcpp_node:\n  ros__parameters: {use_sim_time: true}\n"
         "controller_server:\n  ros__parameters:\n    progress_checker_plugin: "
         "\"progress_checker\"\n" +
         kServerRates + kCheckers + controllerBlock(kDwbPlugin, kDwbLimits + kDwbCritics) +
         costmapsWith("", "") + kMaps + serversWith("nav2_navfn_planner/NavfnPlanner") +
         behaviorsWith("/",
                       "    costmap_topic: local_costmap/costmap_raw\n"
                       "    footprint_topic: local_costmap/published_footprint\n"
                       "    global_frame: odom\n") +
         "robot_state_publisher:\n  ros__parameters: {use_sim_time: true}\n";
}

/// Between Humble and Jazzy: several progress checkers, both costmaps, classes with '/'.
inline std::string ironFile() {
  return kAmcl +
         navigatorWith(
             "    bt_loop_duration: 10\n    default_server_timeout: 20\n"
             "    wait_for_service_timeout: 1000\n" +
             replaced(kNavigators, "::", "/") +
             "    plugin_lib_names:\n      - nav2_compute_path_to_pose_action_bt_node\n"
             "    error_code_names: [compute_path_error_code, follow_path_error_code]\n") +
         "controller_server:\n  ros__parameters:\n    progress_checker_plugins: "
         "[\"progress_checker\"]\n" +
         kServerRates + kCheckers + controllerBlock(kDwbPlugin, kDwbLimits + kDwbCritics) +
         costmapsWith("", "") + kMaps + serversWith("nav2_navfn_planner/NavfnPlanner") +
         behaviorsWith("/", kTwoCostmaps) + kMonitor;
}

inline const std::string kDocking = R"(docking_server:
  ros__parameters:
    controller_frequency: 50.0
    initial_perception_timeout: 5.0
    wait_charge_timeout: 5.0
    dock_approach_timeout: 30.0
    undock_linear_tolerance: 0.05
    undock_angular_tolerance: 0.1
    max_retries: 3
    base_frame: "base_link"
    fixed_frame: "odom"
    dock_prestaging_tolerance: 0.5
    dock_plugins: ["simple_charging_dock"]
    simple_charging_dock:
      plugin: "opennav_docking::SimpleChargingDock"
      docking_threshold: 0.05
      staging_x_offset: -0.7
      use_external_detection_pose: false
      use_battery_status: false
      use_stall_detection: false
      external_detection_timeout: 1.0
      filter_coef: 0.1
    docks: ["home_dock"]
    home_dock:
      type: "simple_charging_dock"
      frame: map
      pose: [1.0, 1.0, 0.0]
    controller:
      k_phi: 3.0
      k_delta: 2.0
      v_linear_min: 0.15
      v_linear_max: 0.15
      use_collision_detection: true
      dock_collision_threshold: 0.3
)";

inline std::string kiltedFile() {
  return kAmcl +
         navigatorWith(
             "    bt_loop_duration: 10\n    filter_duration: 0.3\n"
             "    default_server_timeout: 20\n    wait_for_service_timeout: 1000\n"
             "    service_introspection_mode: \"disabled\"\n" +
             kNavigators +
             "    error_code_name_prefixes:\n      - compute_path\n      - follow_path\n"
             "      - spin\n      - backup\n") +
         "controller_server:\n  ros__parameters:\n    costmap_update_timeout: 0.30\n"
         "    progress_checker_plugins: [\"progress_checker\"]\n"
         "    enable_stamped_cmd_vel: true\n" +
         kServerRates + kCheckers +
         controllerBlock(kMppiPlugin, kMppiKeys +
                                          "      motion_model: \"DiffDrive\"\n"
                                          "      publish_optimal_trajectory: true\n" +
                                          kMppiCritics) +
         costmapsWith("      service_introspection_mode: \"disabled\"\n", "") + kMaps +
         serversWith("nav2_navfn_planner::NavfnPlanner", "    costmap_update_timeout: 1.0\n") +
         behaviorsWith("::", kTwoCostmaps) + kMonitor +
         replaced(kDocking, "      filter_coef: 0.1\n",
                  "      filter_coef: 0.1\n      dock_direction: \"forward\"\n") +
         "loopback_simulator:\n  ros__parameters: {scan_frame_id: \"base_scan\"}\n";
}

inline std::string lyricalFile() {
  return kAmcl +
         navigatorWith(
             "    introspection_mode: \"disabled\"\n    bt_log_idle_transitions: false\n"
             "    filter_duration: 0.3\n    bt_search_directories: [\"trees\"]\n" +
             kNavigators +
             "    error_code_name_prefixes: [compute_path, follow_path, dock_robot]\n") +
         R"(controller_server:
  ros__parameters:
    introspection_mode: "disabled"
    costmap_update_timeout: 0.30
    odom_topic: "odom"
    odom_duration: 0.3
    search_window: 2.0
    progress_checker_plugins: ["progress_checker"]
    path_handler_plugins: ["path_handler"]
    path_handler:
      plugin: "nav2_controller::FeasiblePathHandler"
      prune_distance: 2.0
      enforce_path_inversion: true
      minimum_rotation_angle: 0.785
)" + kServerRates +
         kCheckers +
         controllerBlock(kPursuitPlugin,
                         "      max_linear_vel: 0.6\n      min_linear_vel: 0.0\n"
                         "      max_angular_decel: -3.2\n      lookahead_dist: 0.6\n"
                         "      use_dynamic_window: false\n      use_rotate_to_heading: true\n") +
         costmapsWith("      introspection_mode: \"disabled\"\n",
                      "      subscribe_to_stamped_footprint: false\n") +
         kMaps +
         serversWith("nav2_navfn_planner::NavfnPlanner",
                     "    introspection_mode: \"disabled\"\n    allow_partial_planning: false\n") +
         behaviorsWith("::", kTwoCostmaps) +
         replaced(kMonitor, "    polygons:",
                  "    enabled: true\n    exclusion_zones: [\"arm\"]\n"
                  "    arm:\n      enabled: true\n      type: \"polygon\"\n"
                  "      points: \"[[0.3, 0.1], [0.3, -0.1], [0.1, -0.1], [0.1, 0.1]]\"\n"
                  "      frame_id: \"base_footprint\"\n      visualize: true\n    polygons:") +
         kDocking;
}

/// Every server that a robot may have beside those of the navigation.
inline std::string manyServersFile() {
  return lyricalFile() + R"(following_server:
  ros__parameters:
    controller_frequency: 50.0
    detection_timeout: 2.0
    rotate_to_object_timeout: 10.0
    static_object_timeout: -1.0
    desired_distance: 1.0
    linear_tolerance: 0.15
    angular_tolerance: 0.15
    skip_orientation: true
    search_by_rotating: false
    fixed_frame: "odom"
    base_frame: "base_link"
    controller: {k_phi: 3.0, k_delta: 2.0, use_collision_detection: false}
route_server:
  ros__parameters:
    boundary_radius_to_achieve_node: 1.0
    radius_to_achieve_node: 2.0
    smooth_corners: true
    operations: ["AdjustSpeedLimit", "ReroutingService"]
    ReroutingService: {plugin: "nav2_route::ReroutingService"}
    AdjustSpeedLimit: {plugin: "nav2_route::AdjustSpeedLimit"}
    tracker_update_rate: 50.0
    aggregate_blocked_ids: false
    edge_cost_functions: ["DistanceScorer", "CostmapScorer"]
    DistanceScorer: {plugin: "nav2_route::DistanceScorer"}
    CostmapScorer: {plugin: "nav2_route::CostmapScorer"}
base_footprint_publisher:
  ros__parameters: {base_footprint_frame: "base_footprint"}
collision_detector:
  ros__parameters:
    frequency: 10.0
    observation_sources: ["scan"]
    scan: {type: "scan", topic: "scan"}
)";
}

/// A tree with a node before the navigation and another one among its recoveries.
inline std::string treeWith(const std::string& before, const std::string& recovery) {
  return R"(<root BTCPP_format="4" main_tree_to_execute="MainTree">
  <BehaviorTree ID="MainTree">
    <Sequence>
      )" +
         before +
         R"(
      <RecoveryNode number_of_retries="6" name="NavigateRecovery">
        <PipelineSequence name="NavigateWithReplanning">
          <RateController hz="1.0">
            <ComputePathToPose goal="{goal}" path="{path}" planner_id="GridBased"/>
          </RateController>
          <FollowPath path="{path}" controller_id="FollowPath"/>
        </PipelineSequence>
        <ReactiveFallback>
          <GoalUpdated/>
          <RoundRobin>
            <ClearEntireCostmap service_name="local_costmap/clear_entirely_local_costmap"/>
            )" +
         recovery + R"(
            <Wait wait_duration="2.0"/>
          </RoundRobin>
        </ReactiveFallback>
      </RecoveryNode>
    </Sequence>
  </BehaviorTree>
</root>
)";
}

inline std::vector<Case> wholeCases() {
  const std::string drive =
      "<DriveOnHeading dist_to_travel=\"0.2\" speed=\"0.1\" time_allowance=\"10.0\"/>";
  const std::string teleop =
      "<ForceSuccess><AssistedTeleop time_allowance=\"1.0\"/></ForceSuccess>";
  return {
      {"whole file of Humble", humbleFile(), true},
      {"whole file of Iron", ironFile(), true},
      {"whole file of Kilted", kiltedFile(), true},
      {"whole file of Lyrical", lyricalFile(), true},
      {"docking, following and route server", manyServersFile(), true},
      {"a tree that drives on its heading", humbleFile() + "# a drive\n", true,
       treeWith(drive, drive)},
      {"a tree with assisted teleoperation", kiltedFile() + "# teleoperation\n", true,
       treeWith(teleop, teleop)},
  };
}

/// All of them.
inline std::vector<Case> allCases() {
  std::vector<Case> all;
  for (auto&& part : {controllerCases(), plannerCases(), layerCases(), checkerCases(),
                      smootherCases(), oddCases(), wholeCases()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace nav2set
