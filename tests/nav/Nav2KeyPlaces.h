#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"

/// Every parameter that Nav2 declares, by component, and where it stands in a file.
namespace nav2keys {

struct DeclaredKey {
  std::string name;
  std::vector<std::string> defaults;  // by branch; "-": not declared, "*": not compared
};
using Declared = std::map<std::string, std::vector<DeclaredKey>>;  // by component

inline const Declared& declaredKeys() {
  static const Declared kKeys = [] {
    Declared keys;
    const auto text = base::readTextFile(SOURCE_DIR "/tests/data/nav2/keys.csv");
    bool isHeader = true;
    for (const std::string& line : base::split(text ? *text : std::string(), '\n')) {
      if (line.empty() || line.front() == '#' || std::exchange(isHeader, false)) {
        continue;
      }
      std::vector<std::string> cells = base::split(line, ';');
      keys[cells.at(0)].push_back({cells.at(1), {cells.begin() + 2, cells.end()}});
    }
    return keys;
  }();
  return kKeys;
}

/// Where the keys of a component stand: the head of a file that loads it, and the path of its block
/// ("controller_server.FollowPath.").
struct Place {
  std::string head, path;
  int indent = 4;

  /// A file with one key of the component.
  std::string fileWith(const std::string& key, const std::string& value) const {
    return head + std::string(static_cast<std::size_t>(indent), ' ') + key + ": " + value + "\n";
  }
};

inline std::string controllerHead(const std::string& plugin, const std::string& more = {}) {
  return "controller_server:\n  ros__parameters:\n    controller_plugins: [FollowPath]\n"
         "    FollowPath:\n      plugin: \"" +
         plugin + "\"\n" + more;
}

inline std::string pluginHead(const std::string& node, const std::string& list,
                              const std::string& plugin) {
  return node + ":\n  ros__parameters:\n    " + list + ": [It]\n    It:\n      plugin: \"" +
         plugin + "\"\n";
}

/// A checker or path handler beside a controller, without which its keys would not be read.
inline std::string checkerHead(const std::string& list, const std::string& plugin) {
  return controllerHead("nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController") +
         "    " + list + ": [It]\n    It:\n      plugin: \"nav2_controller::" + plugin + "\"\n";
}

inline Place layerPlace(const std::string& plugin, const char* list = "plugins") {
  return {std::string("local_costmap:\n  local_costmap:\n    ros__parameters:\n      ") + list +
              ": [It]\n      It:\n        plugin: \"nav2_costmap_2d::" + plugin + "\"\n",
          "local_costmap.It.", 8};
}

inline const std::string kMppi = "nav2_mppi_controller::MPPIController";
inline const std::string kDwb = "dwb_core::DWBLocalPlanner";

inline std::map<std::string, Place> nodePlaces() {
  std::map<std::string, Place> places;
  for (const char* const node :
       {"controller_server", "planner_server", "smoother_server", "behavior_server", "bt_navigator",
        "velocity_smoother", "collision_monitor", "amcl", "docking_server", "route_server",
        "map_server", "waypoint_follower", "lifecycle_manager", "loopback_simulator",
        "following_server", "collision_detector", "base_footprint_publisher"}) {
    places[node] = {std::string(node) + ":\n  ros__parameters:\n", std::string(node) + "."};
  }
  places["every_node"] = places.at("planner_server");
  places["costmap_filter_info_server"] = {
      "costmap_filter_info_server:\n  ros__parameters:\n    filter_info_topic: it\n",
      "costmap_filter_info_server."};
  const std::string docks =
      "docking_server:\n  ros__parameters:\n    dock_plugins: [It]\n    It:\n      plugin: "
      "\"opennav_docking::";
  places["simple_charging_dock"] = {docks + "SimpleChargingDock\"\n", "docking_server.It.", 6};
  places["simple_non_charging_dock"] = {docks + "SimpleNonChargingDock\"\n", "docking_server.It.",
                                        6};
  places["dock_instance"] = {"docking_server:\n  ros__parameters:\n    docks: [It]\n    It:\n",
                             "docking_server.It.", 6};
  for (const auto& [component, task] : {std::pair("wait_at_waypoint", "WaitAtWaypoint"),
                                        std::pair("photo_at_waypoint", "PhotoAtWaypoint"),
                                        std::pair("input_at_waypoint", "InputAtWaypoint")}) {
    places[component] = {
        std::string(
            "waypoint_follower:\n  ros__parameters:\n    waypoint_task_executor_plugin: It\n"
            "    It:\n      plugin: \"nav2_waypoint_follower::") +
            task + "\"\n",
        "waypoint_follower.It.", 6};
  }
  places["costmap"] = {"local_costmap:\n  local_costmap:\n    ros__parameters:\n", "local_costmap.",
                       6};
  return places;
}

inline void addControllers(std::map<std::string, Place>& places) {
  const auto add = [&](const char* component, const std::string& plugin) {
    places[component] = {controllerHead(plugin), "controller_server.FollowPath.", 6};
  };
  add("regulated_pure_pursuit",
      "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController");
  add("graceful", "nav2_graceful_controller::GracefulController");
  add("rotation_shim", "nav2_rotation_shim_controller::RotationShimController");
  add("dwb", kDwb);
  add("mppi", kMppi);
  for (const auto& [component, keys] : declaredKeys()) {
    for (const auto& [prefix, plugin] :
         {std::pair<std::string, std::string>("mppi_", kMppi), {"dwb_", kDwb}}) {
      if (component.compare(0, prefix.size(), prefix) == 0) {
        const std::string critic = component.substr(prefix.size());
        places[component] = {
            controllerHead(plugin, "      critics: [" + critic + "]\n      " + critic + ":\n"),
            "controller_server.FollowPath." + critic + ".", 8};
      }
    }
  }
  places["motion_model"] = {controllerHead(kMppi, "      motion_model: It\n      It:\n"),
                            "controller_server.FollowPath.It.", 8};
  places["path_handler"] = {checkerHead("path_handler_plugins", "FeasiblePathHandler"),
                            "controller_server.It.", 6};
  for (const auto& [component, plugin] :
       {std::pair("simple_goal_checker", "SimpleGoalChecker"),
        std::pair("stopped_goal_checker", "StoppedGoalChecker"),
        std::pair("position_goal_checker", "PositionGoalChecker"),
        std::pair("axis_goal_checker", "AxisGoalChecker"),
        std::pair("adaptive_tolerance_goal_checker", "AdaptiveToleranceGoalChecker")}) {
    places[component] = {checkerHead("goal_checker_plugins", plugin), "controller_server.It.", 6};
  }
  for (const auto& [component, plugin] :
       {std::pair("simple_progress_checker", "SimpleProgressChecker"),
        std::pair("pose_progress_checker", "PoseProgressChecker")}) {
    const std::string name = "    progress_checker_plugin: It\n";  // in Humble
    std::string head = checkerHead("progress_checker_plugins", plugin);
    places[component] = {head.insert(head.find("    progress_checker_plugins"), name),
                         "controller_server.It.", 6};
  }
}

inline void addRoutes(std::map<std::string, Place>& places) {
  const auto add = [&](const char* component, const char* list, const char* plugin) {
    places[component] = {pluginHead("route_server", list, std::string("nav2_route::") + plugin),
                         "route_server.It.", 6};
  };
  const char* const kScorers = "edge_cost_functions";
  add("route_distance_scorer", kScorers, "DistanceScorer");
  add("route_time_scorer", kScorers, "TimeScorer");
  add("route_penalty_scorer", kScorers, "PenaltyScorer");
  add("route_costmap_scorer", kScorers, "CostmapScorer");
  add("route_semantic_scorer", kScorers, "SemanticScorer");
  add("route_start_pose_orientation_scorer", kScorers, "StartPoseOrientationScorer");
  add("route_goal_orientation_scorer", kScorers, "GoalOrientationScorer");
  add("route_adjust_speed_limit", "operations", "AdjustSpeedLimit");
  add("route_collision_monitor", "operations", "CollisionMonitor");
  add("route_time_marker", "operations", "TimeMarker");
  add("route_trigger_event", "operations", "TriggerEvent");
}

inline void addMotions(std::map<std::string, Place>& places) {
  places["drive_behavior"] = {
      pluginHead("behavior_server", "behavior_plugins", "nav2_behaviors::BackUp"),
      "behavior_server.It.", 6};
  places["monitor_polygon"] = {
      "collision_monitor:\n  ros__parameters:\n    polygons: [It]\n    It:\n",
      "collision_monitor.It.", 6};
  places["monitor_source"] = {
      "collision_monitor:\n  ros__parameters:\n    observation_sources: [It]\n    It:\n",
      "collision_monitor.It.", 6};
  places["exclusion_zone"] = {
      "collision_monitor:\n  ros__parameters:\n    exclusion_zones: [It]\n    It:\n",
      "collision_monitor.It.", 6};
  places["velocity_polygon"] = {
      "collision_monitor:\n  ros__parameters:\n    polygons: [P]\n    P:\n"
      "      type: velocity_polygon\n      velocity_polygons: [It]\n      It:\n",
      "collision_monitor.P.It.", 8};
}

inline const std::map<std::string, Place>& placesOfComponents() {
  static const std::map<std::string, Place> kPlaces = [] {
    std::map<std::string, Place> places = nodePlaces();
    for (const auto& [component, plugin] :
         {std::pair("static_layer", "StaticLayer"), std::pair("obstacle_layer", "ObstacleLayer"),
          std::pair("voxel_layer", "VoxelLayer"), std::pair("inflation_layer", "InflationLayer"),
          std::pair("legacy_inflation_layer", "LegacyInflationLayer"),
          std::pair("asymmetric_inflation_layer", "AsymmetricInflationLayer"),
          std::pair("denoise_layer", "DenoiseLayer"),
          std::pair("range_sensor_layer", "RangeSensorLayer"),
          std::pair("plugin_container_layer", "PluginContainerLayer")}) {
      places[component] = layerPlace(plugin);
    }
    places["keepout_filter"] = layerPlace("KeepoutFilter", "filters");
    places["binary_filter"] = layerPlace("BinaryFilter", "filters");
    places["speed_filter"] = layerPlace("SpeedFilter", "filters");
    places["zone_parameter_filter"] = layerPlace("ZoneParameterFilter", "filters");
    places["observation_source"] = layerPlace("ObstacleLayer");
    places["observation_source"].head += "        observation_sources: scan\n        scan:\n";
    places["observation_source"].path += "scan.";
    places["observation_source"].indent = 10;
    for (const auto& [component, plugin] :
         {std::pair("navfn", "nav2_navfn_planner::NavfnPlanner"),
          std::pair("theta_star", "nav2_theta_star_planner::ThetaStarPlanner"),
          std::pair("smac_2d", "nav2_smac_planner::SmacPlanner2D"),
          std::pair("smac_hybrid", "nav2_smac_planner::SmacPlannerHybrid"),
          std::pair("smac_lattice", "nav2_smac_planner::SmacPlannerLattice")}) {
      places[component] = {pluginHead("planner_server", "planner_plugins", plugin),
                           "planner_server.It.", 6};
    }
    for (const auto& [component, plugin] :
         {std::pair("simple_smoother", "nav2_smoother::SimpleSmoother"),
          std::pair("savitzky_golay", "nav2_smoother::SavitzkyGolaySmoother"),
          std::pair("constrained_smoother", "nav2_constrained_smoother::ConstrainedSmoother")}) {
      places[component] = {pluginHead("smoother_server", "smoother_plugins", plugin),
                           "smoother_server.It.", 6};
    }
    addControllers(places);
    addMotions(places);
    addRoutes(places);
    return places;
  }();
  return kPlaces;
}

/// Lists name plugins that the file does not have, and change which keys there are.
inline bool isList(const std::string& key) {
  const auto endsWith = [&key](const std::string& end) {
    return key.size() >= end.size() && key.compare(key.size() - end.size(), end.size(), end) == 0;
  };
  return endsWith("plugins") || endsWith("progress_checker_plugin") || key == "polygons" ||
         key == "exclusion_zones" || key == "filters" || key == "critics" ||
         key == "observation_sources" || key == "edge_cost_functions" || key == "operations" ||
         key == "semantic_classes";
}

}  // namespace nav2keys
