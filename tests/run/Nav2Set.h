#pragma once

#include <string>
#include <utility>
#include <vector>

/// Small but complete parameter files: one for each plugin, branch and oddity of files that real
/// robots have. They are put together from pieces.
namespace nav2set {

/// What a file is made of; each piece is YAML below its node, indented by four blanks (by six in
/// costmaps).
struct Pieces {
  std::string controller = R"(    FollowPath:
      plugin: "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"
      desired_linear_vel: 0.7
      lookahead_dist: 0.6
      min_lookahead_dist: 0.3
      max_lookahead_dist: 0.9
      lookahead_time: 1.5
      use_velocity_scaled_lookahead_dist: true
      use_rotate_to_heading: true
      rotate_to_heading_angular_vel: 1.8
      allow_reversing: false
)";
  std::string controllerMore;  // of the server: frequencies, checkers
  std::string planner = R"(    GridBased:
      plugin: "nav2_navfn_planner::NavfnPlanner"
      tolerance: 0.5
      use_astar: false
      allow_unknown: true
)";
  std::string localLayers = R"(      plugins: ["obstacle_layer", "inflation_layer"]
      obstacle_layer:
        plugin: "nav2_costmap_2d::ObstacleLayer"
        observation_sources: scan
        scan: {topic: /scan, max_obstacle_height: 2.0, clearing: true, marking: true,
               data_type: "LaserScan", obstacle_max_range: 2.5, raytrace_max_range: 3.0}
)";
  std::string inflation = R"(      inflation_layer:
        plugin: "nav2_costmap_2d::InflationLayer"
        cost_scaling_factor: 3.0
        inflation_radius: 0.7
)";
  std::string globalLayers = R"(      plugins: ["static_layer", "obstacle_layer", "inflation_layer"]
      static_layer:
        plugin: "nav2_costmap_2d::StaticLayer"
        map_subscribe_transient_local: true
      obstacle_layer:
        plugin: "nav2_costmap_2d::ObstacleLayer"
        observation_sources: scan
        scan: {topic: /scan, max_obstacle_height: 2.0, clearing: true, marking: true,
               data_type: "LaserScan"}
)";
  std::string behaviors = R"(behavior_server:
  ros__parameters:
    behavior_plugins: ["spin", "backup", "wait"]
    spin: {plugin: "nav2_behaviors::Spin"}
    backup: {plugin: "nav2_behaviors::BackUp"}
    wait: {plugin: "nav2_behaviors::Wait"}
)";
  std::string rest;  // other nodes
};

inline std::string fileOf(const Pieces& pieces) {
  return "controller_server:\n  ros__parameters:\n" + pieces.controllerMore + pieces.controller +
         "planner_server:\n  ros__parameters:\n    planner_plugins: [\"GridBased\"]\n" +
         pieces.planner +
         "local_costmap:\n  local_costmap:\n    ros__parameters:\n"
         "      update_frequency: 5.0\n      publish_frequency: 2.0\n      rolling_window: true\n"
         "      width: 4\n      height: 4\n      resolution: 0.05\n      robot_radius: 0.35\n" +
         pieces.localLayers + pieces.inflation +
         "global_costmap:\n  global_costmap:\n    ros__parameters:\n"
         "      update_frequency: 1.0\n      publish_frequency: 1.0\n      resolution: 0.05\n"
         "      robot_radius: 0.35\n      track_unknown_space: true\n" +
         pieces.globalLayers + pieces.inflation + pieces.behaviors + pieces.rest;
}

/// A file of the set.
struct Case {
  std::string name, text;
  bool isQuick = false;   // driven always, the others with HUNAV_ALL_TESTS
  std::string tree = {};  // XML; empty: Humble's tree with replanning and recoveries
};

inline std::string controllerBlock(const std::string& plugin, const std::string& keys) {
  return "    FollowPath:\n      plugin: \"" + plugin + "\"\n" + keys;
}

inline const std::string kDwbLimits = R"(      min_vel_x: 0.0
      max_vel_x: 0.6
      max_vel_theta: 1.5
      max_speed_xy: 0.6
      acc_lim_x: 2.5
      acc_lim_theta: 3.2
      decel_lim_x: -2.5
      decel_lim_theta: -3.2
      vx_samples: 20
      vtheta_samples: 20
      sim_time: 1.7
      linear_granularity: 0.05
      angular_granularity: 0.025
)";
inline const std::string kDwbCritics =
    R"(      critics: ["RotateToGoal", "Oscillation", "BaseObstacle", "GoalAlign", "PathAlign", "PathDist", "GoalDist"]
      BaseObstacle.scale: 0.02
      PathAlign.scale: 32.0
      PathAlign.forward_point_distance: 0.1
      GoalAlign.scale: 24.0
      GoalAlign.forward_point_distance: 0.1
      PathDist.scale: 32.0
      GoalDist.scale: 24.0
      RotateToGoal.scale: 32.0
)";
inline const std::string kMppiKeys = R"(      time_steps: 56
      model_dt: 0.05
      batch_size: 1000
      vx_max: 0.6
      vx_min: -0.2
      wz_max: 1.9
      temperature: 0.3
      gamma: 0.015
)";
inline const std::string kMppiCritics =
    "      critics: [\"ConstraintCritic\", \"CostCritic\", \"GoalCritic\", \"GoalAngleCritic\", "
    "\"PathAlignCritic\", \"PathFollowCritic\", \"PathAngleCritic\", \"PreferForwardCritic\"]\n";
inline const std::string kDwbPlugin = "dwb_core::DWBLocalPlanner";
inline const std::string kMppiPlugin = "nav2_mppi_controller::MPPIController";
inline const std::string kShimPlugin = "nav2_rotation_shim_controller::RotationShimController";
inline const std::string kPursuitPlugin =
    "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController";

inline std::vector<Case> controllerCases() {
  const auto of = [](const std::string& plugin, const std::string& keys) {
    Pieces pieces;
    pieces.controller = controllerBlock(plugin, keys);
    return fileOf(pieces);
  };
  const std::string shimKeys = "      angular_dist_threshold: 0.785\n";
  return {
      {"regulated pure pursuit", fileOf({}), true},
      {"DWB", of(kDwbPlugin, kDwbLimits + kDwbCritics), true},
      {"DWB, limited accelerations",
       of(kDwbPlugin,
          kDwbLimits + kDwbCritics +
              "      trajectory_generator_name: \"dwb_plugins::LimitedAccelGenerator\"\n"
              "      sim_period: 0.1\n")},
      {"DWB, full names, a critic of others",
       of(kDwbPlugin,
          kDwbLimits +
              "      critics: [\"dwb_critics::RotateToGoal\", \"dwb_critics::ObstacleFootprint\", "
              "\"social_critics::Space\", \"dwb_critics::PathAlign\", \"dwb_critics::PathDist\", "
              "\"dwb_critics::GoalDist\", \"dwb_critics::GoalAlign\"]\n")},
      {"MPPI", of(kMppiPlugin, kMppiKeys + kMppiCritics), true},
      {"MPPI, obstacles critic",
       of(kMppiPlugin,
          kMppiKeys + "      critics: [\"ConstraintCritic\", \"ObstaclesCritic\", "
                      "\"GoalCritic\", \"GoalAngleCritic\", \"PathAlignCritic\", "
                      "\"PathFollowCritic\", \"PathAngleCritic\", \"PreferForwardCritic\"]\n")},
      {"MPPI, a critic of others",
       of(kMppiPlugin, kMppiKeys +
                           "      critics: [\"ConstraintCritic\", \"CostCritic\", \"GoalCritic\", "
                           "\"SocialCritic\", \"PathAlignCritic\", \"PathFollowCritic\", "
                           "\"PreferForwardCritic\"]\n")},
      {"graceful", of("nav2_graceful_controller::GracefulController",
                      "      v_linear_max: 0.6\n      v_linear_min: 0.1\n"
                      "      v_angular_max: 1.5\n      initial_rotation: true\n")},
      {"shim over pure pursuit",
       of(kShimPlugin, shimKeys + "      primary_controller: \"" + kPursuitPlugin +
                           "\"\n      desired_linear_vel: 0.6\n")},
      {"shim over DWB", of(kShimPlugin, shimKeys + "      primary_controller: \"" + kDwbPlugin +
                                            "\"\n" + kDwbLimits + kDwbCritics)},
      {"TEB",
       of("teb_local_planner::TebLocalPlannerROS",
          "      max_vel_x: 0.5\n      max_vel_x_backwards: 0.2\n      max_vel_theta: 1.0\n"
          "      acc_lim_x: 1.0\n      acc_lim_theta: 1.5\n      teb_autosize: 1.0\n"
          "      weight_optimaltime: 1.0\n      costmap_converter_plugin: \"\"\n"),
       true},
      {"TEB below a shim", of(kShimPlugin, shimKeys + "      primary_controller: "
                                                      "\"teb_local_planner::TebLocalPlannerROS\"\n"
                                                      "      max_vel_x: 0.5\n")},
      {"vector pursuit", of("vector_pursuit_controller::VectorPursuitController",
                            "      k: 8.0\n      desired_linear_vel: 0.6\n"
                            "      min_lookahead_dist: 0.3\n      use_rotate_to_heading: true\n"
                            "      max_lateral_accel: 0.2\n")},
      {"pure pursuit of a tutorial", of("nav2_pure_pursuit_controller/PurePursuitController",
                                        "      desired_linear_vel: 0.5\n      lookahead_dist: 0.4\n"
                                        "      max_angular_vel: 1.0\n")},
      {"a controller of others",
       of("acme_controllers::Glider", "      max_linear_vel: 0.6\n      gain: 2\n")},
  };
}

inline std::vector<Case> plannerCases() {
  const auto of = [](const std::string& plugin, const std::string& keys) {
    Pieces pieces;
    pieces.planner = "    GridBased:\n      plugin: \"" + plugin + "\"\n" + keys;
    return fileOf(pieces);
  };
  return {
      {"NavFn with A*, Humble's spelling",
       of("nav2_navfn_planner/NavfnPlanner", "      use_astar: true\n      tolerance: 0.5\n")},
      {"Theta*", of("nav2_theta_star_planner::ThetaStarPlanner", "      how_many_corners: 8\n")},
      {"Smac 2D", of("nav2_smac_planner::SmacPlanner2D", "      tolerance: 0.5\n")},
      {"Smac Hybrid, Dubins",
       of("nav2_smac_planner::SmacPlannerHybrid",
          "      motion_model_for_search: \"DUBIN\"\n      minimum_turning_radius: 0.4\n"
          "      angle_quantization_bins: 64\n")},
      {"Smac Hybrid, Reeds-Shepp",
       of("nav2_smac_planner/SmacPlannerHybrid",
          "      motion_model_for_search: \"REEDS_SHEPP\"\n      minimum_turning_radius: 0.4\n")},
      {"Smac of Galactic", of("smac_planner/SmacPlanner",
                              "      tolerance: 0.5\n      motion_model_for_search: DUBIN\n")},
      {"Smac Lattice without its file",
       of("nav2_smac_planner::SmacPlannerLattice",
          "      lattice_filepath: \"/opt/acme/output.json\"\n      rotation_penalty: 5.0\n"
          "      allow_reverse_expansion: false\n")},
      {"a straight line",
       of("nav2_straightline_planner/StraightLine", "      interpolation_resolution: 0.1\n")},
      {"a planner of others", of("acme_planners::RrtStar", "      tolerance: 1\n")},
  };
}

inline std::string localOf(const std::string& names, const std::string& layers) {
  return "      plugins: [" + names + ", \"inflation_layer\"]\n" + layers;
}

inline const std::string kScan =
    "        observation_sources: scan\n"
    "        scan: {topic: /scan, max_obstacle_height: 2.0, clearing: true, marking: true}\n";

inline std::vector<Case> layerCases() {
  const auto of = [](const std::string& names, const std::string& layers) {
    Pieces pieces;
    pieces.localLayers = localOf(names, layers);
    return fileOf(pieces);
  };
  const auto grownBy = [](const std::string& plugin, const std::string& keys) {
    Pieces pieces;
    pieces.inflation = "      inflation_layer:\n        plugin: \"" + plugin + "\"\n" + keys;
    return fileOf(pieces);
  };
  const std::string seen =
      "      seen:\n        plugin: \"nav2_costmap_2d::ObstacleLayer\"\n" + kScan;
  return {
      {"voxel layer", of("\"voxels\"",
                         "      voxels:\n        plugin: \"nav2_costmap_2d::VoxelLayer\"\n"
                         "        z_resolution: 0.05\n        z_voxels: 16\n" +
                             kScan)},
      {"voxels that decay",
       of("\"stvl\"",
          "      stvl:\n        plugin: \"spatio_temporal_voxel_layer/SpatioTemporalVoxelLayer\"\n"
          "        enabled: true\n        voxel_decay: 0.5\n        decay_model: 0\n"
          "        voxel_size: 0.05\n        track_unknown_space: true\n        mark_threshold: 0\n"
          "        update_footprint_enabled: true\n        combination_method: 1\n"
          "        origin_z: 0.0\n        publish_voxel_map: true\n        transform_tolerance: "
          "0.2\n"
          "        mapping_mode: false\n        map_save_duration: 60.0\n"
          "        observation_sources: mark clear\n"
          "        mark: {data_type: PointCloud2, topic: /camera, marking: true, clearing: false,\n"
          "               obstacle_range: 3.0, min_obstacle_height: 0.0, max_obstacle_height: "
          "2.0,\n"
          "               inf_is_valid: false, voxel_filter: true, clear_after_reading: true}\n"
          "        clear: {data_type: PointCloud2, topic: /camera, marking: false, clearing: "
          "true,\n"
          "                min_z: 0.1, max_z: 7.0, vertical_fov_angle: 0.8745,\n"
          "                horizontal_fov_angle: 1.048, decay_acceleration: 5.0, model_type: 0}\n"),
       true},
      {"non-persistent voxels",
       of("\"npvl\"",
          "      npvl:\n        plugin: \"nonpersistent_voxel_layer/NonPersistentVoxelLayer\"\n"
          "        z_voxels: 16\n" +
              kScan)},
      {"denoise",
       of("\"seen\", \"clean\"",
          seen + "      clean:\n        plugin: \"nav2_costmap_2d::DenoiseLayer\"\n"
                 "        minimal_group_size: 2\n        group_connectivity_type: 8\n"),
       true},
      {"range sensors",
       of("\"seen\", \"sonar\"",
          seen + "      sonar:\n        plugin: \"nav2_costmap_2d::RangeSensorLayer\"\n"
                 "        topics: [\"/sonar/front\", \"/sonar/left\", \"/sonar/right\"]\n"
                 "        no_readings_timeout: 0.0\n        clear_on_max_reading: true\n"),
       true},
      {"container",
       of("\"both\"",
          "      both:\n        plugin: \"nav2_costmap_2d::PluginContainerLayer\"\n"
          "        plugins: [\"seen\"]\n        combination_method: 1\n"
          "        seen:\n          plugin: \"nav2_costmap_2d::ObstacleLayer\"\n"
          "          observation_sources: scan\n"
          "          scan: {topic: /scan, max_obstacle_height: 2.0, clearing: true}\n")},
      {"social layers of others",
       of("\"seen\", \"social\"",
          seen + "      social:\n        plugin: \"social_nav_layers/ProxemicLayer\"\n"
                 "        cutoff: 10.0\n        keep_time: 0.75\n")},
      {"legacy inflation", grownBy("nav2_costmap_2d::LegacyInflationLayer",
                                   "        cost_scaling_factor: 3.0\n"
                                   "        inflation_radius: 0.7\n")},
      {"asymmetric inflation",
       grownBy("nav2_costmap_2d::AsymmetricInflationLayer",
               "        cost_scaling_factor_left: 5.0\n"
               "        cost_scaling_factor_right: 3.0\n"
               "        inflation_radius: 0.7\n"),
       true},
      {"filters without masks",
       [] {
         Pieces pieces;
         pieces.globalLayers +=
             "      filters: [\"keepout\", \"speed\", \"lights\", \"zones\"]\n"
             "      keepout: {plugin: \"nav2_costmap_2d::KeepoutFilter\", "
             "enabled: KEEPOUT_ZONE_ENABLED, filter_info_topic: \"/keepout\"}\n"
             "      speed: {plugin: \"nav2_costmap_2d::SpeedFilter\", "
             "filter_info_topic: \"/speed\", speed_limit_topic: \"/speed_limit\"}\n"
             "      lights: {plugin: \"nav2_costmap_2d::BinaryFilter\", default_state: false, "
             "flip_threshold: 50.0}\n"
             "      zones: {plugin: \"nav2_costmap_2d::ZoneParameterFilter\"}\n";
         return fileOf(pieces);
       }()},
  };
}

inline std::vector<Case> checkerCases() {
  const auto of = [](const std::string& plugin, const std::string& keys, const char* progress) {
    Pieces pieces;
    pieces.controllerMore =
        "    goal_checker_plugins: [\"there\"]\n    there:\n      plugin: \"" + plugin + "\"\n" +
        keys + "    progress_checker_plugins: [\"moves\"]\n    moves:\n      plugin: \"" +
        progress + "\"\n      required_movement_radius: 0.5\n      movement_time_allowance: 10.0\n";
    return fileOf(pieces);
  };
  const char* const simple = "nav2_controller::SimpleProgressChecker";
  const std::string place = "      xy_goal_tolerance: 0.25\n";
  return {
      {"simple checkers",
       of("nav2_controller::SimpleGoalChecker",
          place + "      stateful: true\n      yaw_goal_tolerance: 0.25\n", simple)},
      {"stopped checker", of("nav2_controller::StoppedGoalChecker",
                             place + "      trans_stopped_velocity: 0.25\n", simple)},
      {"position checker, pose progress",
       of("nav2_controller::PositionGoalChecker", place, "nav2_controller::PoseProgressChecker")},
      {"DWB's own simple checker", of("dwb_plugins::SimpleGoalChecker", place, simple)},
      {"DWB's own stopped checker", of("dwb_plugins::StoppedGoalChecker", place, simple)},
      {"axis checker",
       of("nav2_controller::AxisGoalChecker",
          "      along_path_tolerance: 0.25\n      cross_track_tolerance: 0.25\n"
          "      is_overshoot_valid: true\n",
          simple),
       true},
      {"adaptive checker", of("nav2_controller::AdaptiveToleranceGoalChecker",
                              "      coarse_xy_goal_tolerance: 0.3\n"
                              "      fine_xy_goal_tolerance: 0.1\n      yaw_goal_tolerance: 3.2\n",
                              simple)},
      {"checkers of others", of("acme_checkers::Gate", place, "acme_checkers::Clock")},
  };
}

inline std::vector<Case> smootherCases() {
  const auto of = [](const std::string& plugin, const std::string& keys) {
    Pieces pieces;
    pieces.rest =
        "smoother_server:\n  ros__parameters:\n    smoother_plugins: [\"smooth\"]\n"
        "    smooth:\n      plugin: \"" +
        plugin + "\"\n" + keys;
    return fileOf(pieces);
  };
  return {
      {"simple smoother", of("nav2_smoother::SimpleSmoother", "      tolerance: 1.0e-10\n")},
      {"Savitzky-Golay smoother", of("nav2_smoother::SavitzkyGolaySmoother", "")},
      {"constrained smoother",
       of("nav2_constrained_smoother/ConstrainedSmoother",
          "      reversing_enabled: true\n      path_downsampling_factor: 3\n"
          "      minimum_turning_radius: 0.4\n      w_curve: 30.0\n      w_dist: 0.0\n"
          "      w_smooth: 30000.0\n      w_cost: 0.015\n      optimizer: {max_iterations: 70}\n")},
      {"a smoother of others", of("acme_smoothers::BSpline", "      order: 3\n")},
  };
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

inline const std::string kMonitor = R"(velocity_smoother:
  ros__parameters:
    smoothing_frequency: 20.0
    feedback: "OPEN_LOOP"
    max_velocity: [0.7, 0.0, 2.0]
    min_velocity: [-0.7, 0.0, -2.0]
    max_accel: [2.5, 0.0, 3.2]
    max_decel: [-2.5, 0.0, -3.2]
    deadband_velocity: [0.0, 0.0, 0.0]
collision_monitor:
  ros__parameters:
    polygons: ["FootprintApproach"]
    FootprintApproach:
      type: "polygon"
      action_type: "approach"
      footprint_topic: "/local_costmap/published_footprint"
      time_before_collision: 1.2
      simulation_time_step: 0.1
      min_points: 6
      visualize: false
      enabled: true
    observation_sources: ["scan"]
    scan: {type: "scan", topic: "scan", min_height: 0.15, max_height: 2.0, enabled: true}
)";

/// Foxy: one goal checker, recoveries, older names of ranges, no velocity smoother.
inline std::string foxyFile() {
  Pieces pieces;
  pieces.controllerMore =
      "    controller_frequency: 20.0\n    progress_checker_plugin: \"progress_checker\"\n"
      "    goal_checker_plugin: \"goal_checker\"\n    controller_plugins: [\"FollowPath\"]\n"
      "    progress_checker: {plugin: \"nav2_controller::SimpleProgressChecker\"}\n"
      "    goal_checker: {plugin: \"nav2_controller::SimpleGoalChecker\", xy_goal_tolerance: 0.25,"
      " yaw_goal_tolerance: 0.25, stateful: true}\n";
  pieces.controller = controllerBlock(kDwbPlugin, kDwbLimits + kDwbCritics);
  pieces.planner = "    GridBased: {plugin: \"nav2_navfn_planner/NavfnPlanner\", tolerance: 0.5}\n";
  pieces.localLayers =
      replaced(replaced(pieces.localLayers, "obstacle_max_range", "obstacle_range"),
               "raytrace_max_range", "raytrace_range");
  pieces.behaviors = R"(recoveries_server:
  ros__parameters:
    costmap_topic: local_costmap/costmap_raw
    footprint_topic: local_costmap/published_footprint
    cycle_frequency: 10.0
    recovery_plugins: ["spin", "backup", "wait"]
    spin: {plugin: "nav2_recoveries/Spin"}
    backup: {plugin: "nav2_recoveries/BackUp"}
    wait: {plugin: "nav2_recoveries/Wait"}
local_costmap_client:
  ros__parameters: {use_sim_time: true}
planner_server_rclcpp_node:
  ros__parameters: {use_sim_time: true}
)";
  return fileOf(pieces);
}

/// Eloquent: lists of names and classes, dotted keys.
inline std::string eloquentFile() {
  std::string drive = replaced(kDwbLimits + kDwbCritics, "      ", "    FollowPath.");
  std::string text = foxyFile();
  text = replaced(text, "    controller_plugins: [\"FollowPath\"]\n",
                  "    controller_plugin_types: [\"dwb_core::DWBLocalPlanner\"]\n"
                  "    controller_plugin_ids: [\"FollowPath\"]\n");
  text = replaced(text, controllerBlock(kDwbPlugin, kDwbLimits + kDwbCritics), drive);
  text = replaced(text, "planner_plugins: [\"GridBased\"]",
                  "planner_plugin_ids: [\"GridBased\"]\n"
                  "    planner_plugin_types: [\"nav2_navfn_planner/NavfnPlanner\"]");
  text = replaced(text, "plugin: \"nav2_navfn_planner/NavfnPlanner\", ", "");
  return replaced(text, "recovery_plugins: [\"spin\", \"backup\", \"wait\"]",
                  "plugin_names: [\"spin\", \"backup\", \"wait\"]\n"
                  "    plugin_types: [\"nav2_recoveries/Spin\", \"nav2_recoveries/BackUp\", "
                  "\"nav2_recoveries/Wait\"]");
}

/// Main: a path handler, a motion model as a plugin.
inline std::string mainFile() {
  Pieces pieces;
  pieces.controllerMore =
      "    path_handler_plugins: [\"handler\"]\n"
      "    handler: {plugin: \"nav2_controller::FeasiblePathHandler\", prune_distance: 2.0}\n";
  pieces.controller =
      controllerBlock(kMppiPlugin, kMppiKeys +
                                       "      motion_model: \"drive\"\n"
                                       "      drive: {plugin: \"mppi::DiffDriveMotionModel\"}\n" +
                                       kMppiCritics);
  return fileOf(pieces);
}

inline std::vector<Case> oddCases() {
  const std::string plain = fileOf({});
  Pieces careful;
  careful.rest = kMonitor;
  return {
      {"Foxy", foxyFile(), true},
      {"Eloquent", eloquentFile()},
      {"main", mainFile(), true},
      {"Jazzy with monitor and smoother of velocities", fileOf(careful)},
      {"a namespace", "acme:\n  " + replaced(plain, "\n", "\n  ") + "\n"},
      {"keys for all nodes", "/**:\n  ros__parameters:\n    use_sim_time: true\n" + plain},
      {"a key twice", replaced(plain, "      width: 4\n", "      width: 3\n      width: 4\n")},
      {"words of launch files",
       replaced(replaced(plain, "plugins: [\"obstacle_layer\", \"inflation_layer\"]",
                         "plugins: TO_BE_OVERRIDDEN"),
                "planner_plugins: [\"GridBased\"]", "planner_plugins: TO_BE_OVERRIDDEN"),
       true},
      {"empty lists",
       replaced(replaced(plain, "planner_plugins: [\"GridBased\"]", "planner_plugins: [\"\"]"),
                "      update_frequency: 1.0\n",
                "      update_frequency: 1.0\n      filters: []\n")},
      {"behaviours of others",
       replaced(plain, "\"wait\"]",
                "\"wait\", \"dance\"]\n"
                "    dance: {plugin: \"acme_behaviors::Dance\", turns: 3}")},
      {"a footprint", replaced(plain, "robot_radius: 0.35",
                               "footprint: \"[[0.3, 0.2], [0.3, -0.2], [-0.3, -0.2], "
                               "[-0.3, 0.2]]\"")},
  };
}

}  // namespace nav2set
