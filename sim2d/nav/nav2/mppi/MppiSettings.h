#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

/// Parameters of Nav2's MPPI (nav2_mppi_controller::MPPIController).
namespace sim2d::nav2 {

/// The vectorized code computes in single precision.
constexpr float toFloat(double value) {
  return static_cast<float>(value);
}

enum class MppiMotion : std::uint8_t { DiffDrive, Omni, Ackermann };

struct MppiSettings {
  int timeSteps = 56;
  double modelDt = 0.05;  // [s]
  int batchSize = 1000;
  int iterationCount = 1;
  double temperature = 0.3;  // lambda
  double gamma = 0.015;
  double vxMax = 0.5, vxMin = -0.35, vyMax = 0.5;               // [m/s]
  double wzMax = 1.9;                                           // [rad/s]
  double axMax = 3.0, axMin = -3.0, ayMax = 3.0, ayMin = -3.0;  // [m/s²]
  double azMax = 3.5;                                           // [rad/s²]
  double vxStd = 0.2, vyStd = 0.2, wzStd = 0.4;                 // [m/s], [m/s], [rad/s]
  double vxDelay = 0.0, vyDelay = 0.0, wzDelay = 0.0;           // [s]
  std::string motionModel = "DiffDrive";  // main: name of the motion model's block
  double minTurningRadius = 0.2;          // [m]
  int retryAttemptLimit = 1;
  bool regeneratesNoises = false;
  bool isOpenLoop = false;
  bool clampsRawControls = false;
  int sgfOrder = 2;
  double resetPeriod = 1.0;  // [s]
  std::vector<std::string> critics;
  double collisionLookahead = 2.0;  // [s], of the validator
  bool validatesFootprint = false;  // of the validator
  double searchDistance = 0.0;      // [m], 0: half the costmap
  double pruneDistance = 1.5;       // [m]
  bool enforcesInversion = false;
  double inversionXyTolerance = 0.2;   // [m]
  double inversionYawTolerance = 0.4;  // [rad]
};

/// Parameters of the critics. `criticSettingsOf` provides the defaults of each release.
struct CommonCriticSettings {
  bool isEnabled = true;
  double weight = 1.0;  // cost_weight
  int power = 1;        // cost_power; values below 1 count as 1
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

struct DeadbandSettings : CommonCriticSettings {
  DeadbandSettings() { weight = 35.0; }
  std::vector<double> velocities = {0.0, 0.0, 0.0};  // vx [m/s], vy [m/s], wz [rad/s]
};

struct MppiCriticSettings {
  CommonCriticSettings constraint{true, 4.0, 1};
  CostSettings cost;
  ObstaclesSettings obstacles;
  GoalSettings goal;
  GoalAngleSettings goalAngle;
  PathAlignSettings pathAlign;
  PathFollowSettings pathFollow;
  PathAngleSettings pathAngle;
  PreferForwardSettings preferForward;
  CommonCriticSettings twirling{true, 10.0, 1};
  DeadbandSettings deadband;
};

/// The defaults of a release's code.
MppiCriticSettings criticSettingsOf(Distro distro);

/// Calls `visit("GoalCritic", settings.goal)` for every critic.
template <class Settings, class Visit>
void visitCritics(Settings& settings, const Visit& visit) {
  visit("ConstraintCritic", settings.constraint);
  visit("CostCritic", settings.cost);
  visit("ObstaclesCritic", settings.obstacles);
  visit("GoalCritic", settings.goal);
  visit("GoalAngleCritic", settings.goalAngle);
  visit("PathAlignCritic", settings.pathAlign);
  visit("PathFollowCritic", settings.pathFollow);
  visit("PathAngleCritic", settings.pathAngle);
  visit("PreferForwardCritic", settings.preferForward);
  visit("TwirlingCritic", settings.twirling);
  visit("VelocityDeadbandCritic", settings.deadband);
}

/// Data from which MPPI is created.
struct MppiConfiguration {
  Distro distro = Distro::Jazzy;
  MppiSettings settings;
  MppiCriticSettings critics;
  MppiMotion motion = MppiMotion::DiffDrive;
};

/// Reads a controller's block and reports all its problems: wrong types, invalid values, unknown
/// critics and motion models.
base::Result<MppiConfiguration> readMppi(const Nav2ParameterBlock& block, Distro distro);
/// The keys of such a block: those of the optimizer, the critics and main's motion model.
Nav2KeyTable mppiKeysOf(const Nav2ParameterBlock& block, Distro distro);

/// How the sequence is shifted between calls, depending on the controller period and model_dt.
enum class MppiShift : std::uint8_t { Refused, Keeps, Shifts };
MppiShift mppiShiftOf(double period, double modelDt);  // [s]

}  // namespace sim2d::nav2
