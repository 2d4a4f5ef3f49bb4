#pragma once

/// A robot that is too fast for two people in a room of 12 x 2 m, who ignore each other and it.
constexpr const char* const kFastRobot = R"(hunav_loader:
  ros__parameters:
    yaml_base_name: fast_robot
    simulator: Gazebo Classic
    map: open
    publish_people: true
    global_goals:
      1: {x: 1.0, y: 2.0}
      2: {x: 11.0, y: 2.6}
    agents: [anna, ben]
    anna:
      id: 1
      max_vel: 1.2
      radius: 0.3
      goal_radius: 0.3
      cyclic_goals: false
      init_pose: {x: 11.0, y: 2.0, h: 3.142}
      behavior: {type: 1, configuration: 1, goal_force_factor: 2.0, obstacle_force_factor: 10.0, social_force_factor: 0.0, other_force_factor: 20.0}
      goals: [1]
    ben:
      id: 2
      max_vel: 1.0
      radius: 0.3
      goal_radius: 0.3
      cyclic_goals: false
      init_pose: {x: 4.0, y: 2.6, h: 0.0}
      behavior: {type: 1, configuration: 1, goal_force_factor: 2.0, obstacle_force_factor: 10.0, social_force_factor: 0.0, other_force_factor: 20.0}
      goals: [2]
hunavsim_desktop:
  ros__parameters:
    format: 1
    map_file: none
    robots: [robot1]
    robot1:
      planner: pursuit
      start: {x: 1.0, y: 2.0, h: 0.0}
      goal: {x: 10.5, y: 2.0}
      max_vel: 3.0
      max_acc: 1.0
    obstacles: [room]
    room:
      kind: wall
      xs: [0.0, 12.0, 12.0, 0.0, 0.0]
      ys: [1.2, 1.2, 3.2, 3.2, 1.2]
)";
