#pragma once

#include <string>

#include "sim2d/base/Text.h"

/// Scenarios and files for tests of robots that Nav2 drives.
namespace nav2scene {

inline std::string inTmp(const std::string& name) {
  return std::string(TEST_OUTPUT_DIR) + "/tmp/" + name;
}

/// Writes a file and returns its path.
inline std::string written(const std::string& name, const std::string& text) {
  base::writeFileAtomically(inTmp(name), text);
  return inTmp(name);
}

/// The content of a file; empty if it cannot be read.
inline std::string textOf(const std::string& path) {
  const auto text = base::readTextFile(path);
  return text ? *text : std::string();
}

/// A file with one tree of these nodes.
inline std::string treeFile(const std::string& name, const std::string& nodes) {
  return written(
      name, "<root BTCPP_format=\"4\" main_tree_to_execute=\"T\"><BehaviorTree ID=\"T\">" + nodes +
                "</BehaviorTree></root>");
}

/// Warnings and errors, one per line.
inline std::string problemsText(const base::Diagnostics& problems) {
  std::string text;
  for (const base::Diagnostic& problem : problems) {
    text += problem.severity == base::Severity::Info ? "" : problem.text() + "\n";
  }
  return text;
}

/// The only agent of a plane.
struct Anna {
  std::string maxVel = "0.5";
  std::string place = "x: 4.0, y: 30.0";
  std::string goal = "1";
  std::string behavior = "Regular";
};

/// A plane without map, with one agent and one listed robot. `robot`: the keys of robot1 and all
/// that follows; `goals`: lines of global goals.
inline std::string planeText(const std::string& robot, const Anna& anna = {},
                             const std::string& goals = "      1: {x: 4.0, y: 30.0}\n") {
  return R"(hunav_loader:
  ros__parameters:
    map: none
    agents: [anna]
    anna:
      id: 1
      skin: 0
      group_id: -1
      max_vel: )" +
         anna.maxVel + R"(
      radius: 0.3
      init_pose: {)" +
         anna.place + R"(, z: 1.25, h: 0.0}
      goal_radius: 0.3
      cyclic_goals: false
      goals: [)" +
         anna.goal + R"(]
      behavior: {type: )" +
         anna.behavior +
         R"(, configuration: 0, goal_force_factor: 2.0, obstacle_force_factor: 10.0, social_force_factor: 5.0, other_force_factor: 20.0}
    global_goals:
)" + goals +
         R"(hunavsim_desktop:
  ros__parameters:
    format: 1
    map_file: none
    robots: [robot1]
    robot1:
)" + robot;
}

/// A robot that drives 8 m along +x.
inline const std::string kStraight =
    "      start: {x: 0.0, y: 0.0, h: 0.0}\n      goal: {x: 8.0, y: 0.0}\n";
/// A robot of planner nav2 at the origin.
inline const std::string kAtOrigin = "      planner: nav2\n      start: {x: 0.0, y: 0.0, h: 0.0}\n";

}  // namespace nav2scene
