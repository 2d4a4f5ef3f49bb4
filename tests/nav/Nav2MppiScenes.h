#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/mppi/MppiCritics.h"
#include "sim2d/nav/nav2/mppi/MppiOptimizer.h"

/// Places for Nav2's MPPI made by hand.
namespace nav2test {

using namespace sim2d::nav2;

/// Critics of nav2_bringup's file, in its order.
inline std::vector<std::string> stockCritics() {
  return {"ConstraintCritic", "CostCritic",       "GoalCritic",      "GoalAngleCritic",
          "PathAlignCritic",  "PathFollowCritic", "PathAngleCritic", "PreferForwardCritic"};
}

struct HandScene {
  Pose2 robot;
  sim2d::BodyTwist speed;
  Path path;
  Pose2 goal;
  Costmap costmap{60, 60, 0.05, Vec2(-1.5, -1.5)};
  RobotFootprint shape;
  double xyGoalTolerance = 0.25;

  HandScene() {
    shape.vertices = {{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.3, -0.2}};
    shape.inscribedRadius = 0.2;
    shape.circumscribedRadius = std::hypot(0.3, 0.2);
    shape.isRadius = false;
    shape.costScaling = 3.0;
    shape.inflationRadius = 0.7;
  }
  /// A straight path from the origin along +x; the goal is its end.
  void goAhead(double length, int points) {
    path.clear();
    for (int i = 0; i < points; ++i) {
      path.push_back({Vec2(length * i / (points - 1), 0.0), 0.0});
    }
    goal = path.back();
  }
  /// Costs as inflation gives them round an obstacle of one cell at `place`.
  void addObstacle(const Vec2& place) {
    for (int row = 0; row < costmap.height(); ++row) {
      for (int column = 0; column < costmap.width(); ++column) {
        const double d = (costmap.cellToWorld({column, row}) - place).norm();
        double cost = 0.0;
        if (d < 0.5 * costmap.resolution()) {
          cost = 254.0;
        } else if (d <= shape.inscribedRadius) {
          cost = 253.0;
        } else if (d <= shape.inflationRadius) {
          cost = std::floor(252.0 * std::exp(-shape.costScaling * (d - shape.inscribedRadius)));
        }
        if (cost > costmap.at({column, row})) {
          costmap.set({column, row}, static_cast<std::uint8_t>(cost));
        }
      }
    }
  }
  MppiScene view() const { return {robot, speed, path, goal, costmap, shape, xyGoalTolerance}; }
};

/// A curve to the left past an obstacle, the robot on its way: nothing on a symmetry axis.
inline HandScene curve() {
  HandScene scene;
  scene.robot = {Vec2(0.03, -0.02), 0.4};
  scene.speed = {0.25, 0.1, 0.0};
  for (int i = 0; i < 33; ++i) {
    const double s = 0.05 * i;
    scene.path.push_back({Vec2(s, 0.25 * s * s), std::atan(0.5 * s)});
  }
  scene.goal = {Vec2(3.0, 2.3), 0.9};
  scene.addObstacle(Vec2(0.775, -0.425));
  scene.addObstacle(Vec2(0.325, 0.825));
  return scene;
}

/// As code has it, with the critics of the bringup.
inline MppiConfiguration stockMppi(Distro distro) {
  MppiConfiguration mppi;
  mppi.distro = distro;
  mppi.critics = criticSettingsOf(distro);
  mppi.settings.critics = stockCritics();
  return mppi;
}

}  // namespace nav2test
