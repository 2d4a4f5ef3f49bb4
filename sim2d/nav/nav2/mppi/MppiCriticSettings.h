#pragma once

#include <vector>

#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

/// Parameters of the critics of Nav2's MPPI. `criticSettingsOf` provides the defaults of each
/// release.
namespace sim2d::nav2 {

struct CommonCriticSettings {
  bool isEnabled = true;
  double weight = 1.0;  // cost_weight
  int power = 1;        // cost_power; values below 1 count as 1
};

struct ConstraintSettings : CommonCriticSettings {
  ConstraintSettings() { weight = 4.0; }
};

struct CostSettings : CommonCriticSettings {
  CostSettings() { weight = 3.81; }
  double criticalCost = 300.0;
  double collisionCost = 1e6;
  double nearGoalDistance = 0.5;  // [m]
  int nearCollisionCost = 253;
  bool considersFootprint = false;
  int pointStep = 2;  // steps between evaluated poses
};

struct ObstaclesSettings : CommonCriticSettings {
  double repulsionWeight = 1.5;
  double criticalWeight = 20.0;
  double collisionCost = 1e5;
  double marginDistance = 0.10;   // [m]
  double nearGoalDistance = 0.5;  // [m]
  bool considersFootprint = false;
  double costScaling = 10.0;      // [1/m], Humble: a key of the critic
  double inflationRadius = 0.55;  // [m], Humble: a key of the critic
};

struct GoalSettings : CommonCriticSettings {
  GoalSettings() { weight = 5.0; }
  double threshold = 1.4;  // [m]
};

struct GoalAngleSettings : CommonCriticSettings {
  GoalAngleSettings() { weight = 3.0; }
  double threshold = 0.5;  // [m]
  bool isSymmetric = false;
};

struct PathAlignSettings : CommonCriticSettings {
  PathAlignSettings() { weight = 10.0; }
  double threshold = 0.5;  // [m]
  int offsetFromFurthest = 20;
  int pointStep = 4;
  double maxPathOccupancyRatio = 0.07;  // ratio
  bool usesOrientations = false;
};

struct PathFollowSettings : CommonCriticSettings {
  PathFollowSettings() { weight = 5.0; }
  double threshold = 1.4;  // [m]
  int offsetFromFurthest = 6;
};

struct PathAngleSettings : CommonCriticSettings {
  PathAngleSettings() { weight = 2.2; }
  double threshold = 0.5;  // [m]
  int offsetFromFurthest = 4;
  double maxAngleToFurthest = 0.785398;  // [rad]
  int mode = 0;                    // 0: forward, 1: either direction, 2: as the path's headings
  bool isForwardPreferred = true;  // Humble; replaces the mode
};

struct PreferForwardSettings : CommonCriticSettings {
  PreferForwardSettings() { weight = 5.0; }
  double threshold = 0.5;  // [m]
};

struct TwirlingSettings : CommonCriticSettings {
  TwirlingSettings() { weight = 10.0; }
};

struct DeadbandSettings : CommonCriticSettings {
  DeadbandSettings() { weight = 35.0; }
  std::vector<double> velocities = {0.0, 0.0, 0.0};  // vx [m/s], vy [m/s], wz [rad/s]
};

struct MppiCriticSettings {
  ConstraintSettings constraint;
  CostSettings cost;
  ObstaclesSettings obstacles;
  GoalSettings goal;
  GoalAngleSettings goalAngle;
  PathAlignSettings pathAlign;
  PathFollowSettings pathFollow;
  PathAngleSettings pathAngle;
  PreferForwardSettings preferForward;
  TwirlingSettings twirling;
  DeadbandSettings deadband;
};

/// The defaults of a release's code.
MppiCriticSettings criticSettingsOf(Distro distro);

const std::vector<Nav2Key<ConstraintSettings>>& constraintKeys();
const std::vector<Nav2Key<CostSettings>>& costCriticKeys();
const std::vector<Nav2Key<ObstaclesSettings>>& obstaclesCriticKeys();
const std::vector<Nav2Key<GoalSettings>>& goalCriticKeys();
const std::vector<Nav2Key<GoalAngleSettings>>& goalAngleKeys();
const std::vector<Nav2Key<PathAlignSettings>>& pathAlignKeys();
const std::vector<Nav2Key<PathFollowSettings>>& pathFollowKeys();
const std::vector<Nav2Key<PathAngleSettings>>& pathAngleKeys();
const std::vector<Nav2Key<PreferForwardSettings>>& preferForwardKeys();
const std::vector<Nav2Key<TwirlingSettings>>& twirlingKeys();
const std::vector<Nav2Key<DeadbandSettings>>& deadbandKeys();
/// Ignored keys of all critics.
const std::vector<IgnoredKey>& ignoredCriticKeys();

/// Calls `visit("GoalCritic", settings.goal, goalCriticKeys())` for every critic.
template <class Settings, class Visit>
void visitCritics(Settings& settings, const Visit& visit) {
  visit("ConstraintCritic", settings.constraint, constraintKeys());
  visit("CostCritic", settings.cost, costCriticKeys());
  visit("ObstaclesCritic", settings.obstacles, obstaclesCriticKeys());
  visit("GoalCritic", settings.goal, goalCriticKeys());
  visit("GoalAngleCritic", settings.goalAngle, goalAngleKeys());
  visit("PathAlignCritic", settings.pathAlign, pathAlignKeys());
  visit("PathFollowCritic", settings.pathFollow, pathFollowKeys());
  visit("PathAngleCritic", settings.pathAngle, pathAngleKeys());
  visit("PreferForwardCritic", settings.preferForward, preferForwardKeys());
  visit("TwirlingCritic", settings.twirling, twirlingKeys());
  visit("VelocityDeadbandCritic", settings.deadband, deadbandKeys());
}

}  // namespace sim2d::nav2
