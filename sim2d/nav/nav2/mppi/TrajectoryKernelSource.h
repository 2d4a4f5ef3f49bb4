#pragma once

#include "sim2d/nav/nav2/mppi/TrajectoryCollisions.h"
#include "sim2d/nav/nav2/mppi/TrajectoryCritics.h"
#include "sim2d/nav/nav2/mppi/TrajectoryKernel.h"
#include "sim2d/nav/nav2/mppi/TrajectoryRollout.h"

/// Include once in the source file of each instruction set.
namespace sim2d::nav2 {
namespace {

inline TrajectoryKernel compiledTrajectoryKernel() {
  TrajectoryKernel kernel{};
  kernel.draw = drawTrajectoryNoise;
  kernel.roll = rolloutTrajectories;
  kernel.nearest = nearestPathPoints;
  kernel.constraint = scoreConstraint;
  kernel.cost = scoreCost;
  kernel.obstacles = scoreObstacles;
  kernel.goal = scoreGoal;
  kernel.goalAngle = scoreGoalAngle;
  kernel.align = scoreAlign;
  kernel.follow = scoreFollow;
  kernel.angle = scoreAngle;
  kernel.forward = scoreForward;
  kernel.twirling = scoreTwirling;
  kernel.deadband = scoreDeadband;
  kernel.mean = meanOfControls;
  return kernel;
}

}  // namespace
}  // namespace sim2d::nav2
