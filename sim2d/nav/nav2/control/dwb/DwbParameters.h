#pragma once

#include <string>
#include <vector>

#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

namespace sim2d::nav2 {

/// Keys of dwb_core::DWBLocalPlanner and its trajectory generators; keys of critics are in their
/// own blocks.
struct DwbParameters {
  // Kinematic limits; a negative speed limit disables its check.
  double minVelX = 0.0, maxVelX = 0.0;        // [m/s]
  double minVelY = 0.0, maxVelY = 0.0;        // [m/s]
  double maxVelTheta = 0.0;                   // [rad/s]
  double minSpeedXy = 0.0, maxSpeedXy = 0.0;  // [m/s]
  double minSpeedTheta = 0.0;                 // [rad/s]
  double accLimX = 0.0, accLimY = 0.0;        // [m/s^2]
  double accLimTheta = 0.0;                   // [rad/s^2]
  double decelLimX = 0.0, decelLimY = 0.0;    // [m/s^2], <= 0
  double decelLimTheta = 0.0;                 // [rad/s^2], <= 0
  // Trajectories.
  std::string generator = "dwb_plugins::StandardTrajectoryGenerator";
  double simTime = 1.7;    // [s]
  double simPeriod = 0.0;  // LimitedAccel [s]; 0: one controller cycle
  int vxSamples = 20, vySamples = 5, vthetaSamples = 20;
  bool discretizesByTime = false;
  double timeGranularity = 0.5;       // [s]
  double linearGranularity = 0.5;     // [m]
  double angularGranularity = 0.025;  // [rad]
  bool includesLastPoint = true;
  bool limitsCommand = false;  // limit_vel_cmd_in_traj
  // Evaluation.
  std::vector<std::string> critics;           // required
  std::vector<std::string> criticNamespaces;  // empty: dwb_critics
  bool shortCircuits = true;
  double transStoppedVelocity = 0.25;  // [m/s], RotateToGoal
  double xyGoalTolerance = 0.25;       // [m], RotateToGoal
  // Path pruning, until Jazzy.
  bool prunesPlan = true;
  double pruneDistance = 2.0;         // [m]
  double forwardPruneDistance = 2.0;  // [m]
  bool shortensPlan = true;
};

const std::vector<Nav2Key<DwbParameters>>& dwbKeys();
const std::vector<IgnoredKey>& ignoredDwbKeys();

}  // namespace sim2d::nav2
