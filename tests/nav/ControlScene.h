#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/GoalCheckers.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

/// A robot at the origin of a free local costmap, for tests of controllers.
namespace control_scene {

using namespace sim2d::nav2;

inline bool isNear(double a, double b, double tolerance = 1e-9) {
  return std::abs(a - b) <= tolerance;
}

/// Poses every `step` [m] along the x axis from 0 to `length` [m].
inline Path straight(double length, double step = 0.05) {
  Path path;
  const int count = static_cast<int>(std::lround(length / step));
  for (int i = 0; i <= count; ++i) {
    path.push_back({base::Vec2(i * step, 0.0), 0.0});
  }
  return path;
}

inline std::unique_ptr<GoalChecker> goalChecker(sim2d::nav2::Distro distro,
                                                const Nav2ParameterBlock& block = {}) {
  return *makeGoalChecker("nav2_controller::SimpleGoalChecker", distro, block);
}

struct Scene {
  explicit Scene(Distro distroGiven = Distro::Jazzy)
      : distro(distroGiven), checker(goalChecker(distroGiven)) {
    const CostmapFootprint footprint = costmapFootprint(0.22, {}, 0.01);
    shape.vertices = footprint.corners;
    shape.inscribedRadius = footprint.inscribed;
    shape.circumscribedRadius = footprint.circumscribed;
  }

  Distro distro;
  Pose2 robot;
  sim2d::BodyTwist speed;
  Costmap costmap{60, 60, 0.05, base::Vec2(-1.5, -1.5)};  // 3 m x 3 m round the origin
  RobotFootprint shape;
  std::unique_ptr<GoalChecker> checker;
  double time = 0.0;
  Path local;  // main: the local path

  /// The controller with what is given in the block.
  std::unique_ptr<Controller> make(const std::string& plugin,
                                   const Nav2ParameterBlock& block) const {
    ControllerSetup setup;
    setup.distro = distro;
    setup.block = block;
    return *makeController(plugin, setup);
  }
  ControlResult run(Controller& controller) {
    const ControlInput input{
        robot, speed, costmap, shape, *checker, time, distro >= Distro::Lyrical ? &local : nullptr};
    return controller.computeVelocityCommands(input);
  }
  /// Lethal cells in a rectangle of the world [m].
  void block(double x0, double y0, double x1, double y1, std::uint8_t cost = kLethal) {
    for (int row = 0; row < costmap.height(); ++row) {
      for (int column = 0; column < costmap.width(); ++column) {
        const base::Vec2 centre = costmap.cellToWorld({column, row});
        if (centre.x() > x0 && centre.x() < x1 && centre.y() > y0 && centre.y() < y1) {
          costmap.set({column, row}, cost);
        }
      }
    }
  }
};

/// DWB as in Humble's bringup, without the critics that look at the goal's heading and at flips.
inline Nav2ParameterBlock bringup() {
  return {{"max_vel_x", 0.26},
          {"max_vel_theta", 1.0},
          {"max_speed_xy", 0.26},
          {"acc_lim_x", 2.5},
          {"acc_lim_theta", 3.2},
          {"decel_lim_x", -2.5},
          {"decel_lim_theta", -3.2},
          {"linear_granularity", 0.05},
          {"critics", std::vector<std::string>{"BaseObstacle", "GoalAlign", "PathAlign", "PathDist",
                                               "GoalDist"}},
          {"BaseObstacle.scale", 0.02},
          {"GoalAlign.scale", 24.0},
          {"GoalAlign.forward_point_distance", 0.1},
          {"PathAlign.scale", 32.0},
          {"PathAlign.forward_point_distance", 0.1},
          {"PathDist.scale", 32.0},
          {"GoalDist.scale", 24.0}};
}

}  // namespace control_scene
