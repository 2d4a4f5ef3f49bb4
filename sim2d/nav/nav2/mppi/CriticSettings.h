#pragma once

#include <vector>

#include "sim2d/nav/nav2/Nav2Key.h"

/// Parameters of the critics of Nav2's MPPI. What differs between the releases is set by
/// `criticSettingsOf`.
namespace sim2d::nav2 {

struct CriticSettings {
  bool isEnabled = true;
  double weight = 1.0;  // cost_weight
  int power = 1;        // cost_power; what is below counts as 1
};

struct ConstraintSettings : CriticSettings {
  ConstraintSettings() { weight = 4.0; }
};

struct CostSettings : CriticSettings {
  CostSettings() { weight = 3.81; }
  double criticalCost = 300.0;
  double collisionCost = 1e6;
  double nearGoalDistance = 0.5;  // [m]
  int nearCollisionCost = 253;
  bool considersFootprint = false;
  int pointStep = 2;  // steps between the poses looked at
};

struct ObstaclesSettings : CriticSettings {
  double repulsionWeight = 1.5;
  double criticalWeight = 20.0;
  double collisionCost = 1e5;
  double marginDistance = 0.10;   // [m]
  double nearGoalDistance = 0.5;  // [m]
  bool considersFootprint = false;
  double costScaling = 10.0;      // [1/m], Humble: the critic's own
  double inflationRadius = 0.55;  // [m], idem
};

struct GoalSettings : CriticSettings {
  GoalSettings() { weight = 5.0; }
  double threshold = 1.4;  // [m]
};

struct GoalAngleSettings : CriticSettings {
  GoalAngleSettings() { weight = 3.0; }
  double threshold = 0.5;  // [m]
  bool isSymmetric = false;
};

struct PathAlignSettings : CriticSettings {
  PathAlignSettings() { weight = 10.0; }
  double threshold = 0.5;  // [m]
  int offsetFromFurthest = 20;
  int pointStep = 4;
  double mostOccupied = 0.07;  // share
  bool usesOrientations = false;
};

struct PathFollowSettings : CriticSettings {
  PathFollowSettings() { weight = 5.0; }
  double threshold = 1.4;  // [m]
  int offsetFromFurthest = 6;
};

struct PathAngleSettings : CriticSettings {
  PathAngleSettings() { weight = 2.2; }
  double threshold = 0.5;  // [m]
  int offsetFromFurthest = 4;
  double mostAngle = 0.785398;     // [rad]
  int mode = 0;                    // 0: forward, 1: either end, 2: as the path says
  bool isForwardPreferred = true;  // Humble, instead of the mode
};

struct PreferForwardSettings : CriticSettings {
  PreferForwardSettings() { weight = 5.0; }
  double threshold = 0.5;  // [m]
};

struct TwirlingSettings : CriticSettings {
  TwirlingSettings() { weight = 10.0; }
};

struct DeadbandSettings : CriticSettings {
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

/// The defaults of the code of a release.
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
/// Of each critic.
const std::vector<IdleKey>& criticIdleKeys();

/// `visit("GoalCritic", settings.goal, goalCriticKeys())` for every critic there is.
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
