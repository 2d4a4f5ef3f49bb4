#pragma once

#include <string_view>

#include "sim2d/nav/Body.h"
#include "sim2d/nav/Lidar.h"
#include "sim2d/nav/Localization.h"
#include "sim2d/nav/PeopleDetector.h"
#include "sim2d/scenario/Scenario.h"

namespace sim2d {

/// Effective values of an agent: defaults for absent keys, presets and kinds are applied, nothing
/// is drawn yet.
struct ResolvedHuman {
  std::string name;
  int id = -1;
  int groupId = -1;
  double desiredSpeed = 1.0;  // v0 [m/s]
  double radius = 0.35;       // r [m]
  double mass = 80.0;         // [kg]
  double goalRadius = 0.3;    // rho [m]
  Pose2 start;
  bool cyclicGoals = true;
  bool reactionOnce = false;
  BehaviorType behavior = BehaviorType::Regular;
  Configuration configuration = Configuration::Default;
  PersonKind kind = PersonKind::Adult;
  Route route = Route::Planned;
  AtEnd atEnd = AtEnd::Stop;
  // reaction to the robot
  double noticeDistance = 5.0;                                         // [m]
  double reactionDuration = 40.0;                                      // [s]
  double reactionSpeed = 1.0;                                          // [m/s]; `vel`, else max_vel
  double safeDistance = 5.0, stopDistance = 1.5, frontDistance = 1.5;  // [m]
  // force factors
  double goalFactor = 2.0, obstacleFactor = 10.0, socialFactor = 5.0, otherFactor = 20.0;
  // keys of hunavsim_desktop
  double startTime = 0.0;     // [s]
  double reactionTime = 1.0;  // factor of the model's relaxation time
  bool isVaried = false;      // drawn for this seed, see Variation.h
  std::string model = "sfm";
  std::vector<std::pair<std::string, double>> modelParameters;  // only those given
  std::vector<double> wait;
};

struct ResolvedRobot {
  int id = -1;
  std::string name, type = "generic", planner = "pursuit";
  std::string command;                                            // of planner external
  std::vector<std::pair<std::string, double>> plannerParameters;  // the numeric ones
  std::vector<std::pair<std::string, std::string>> plannerTexts;  // all, as text
  std::vector<std::string> nav2Params;                            // of planner nav2; empty: default
  std::string nav2Tree;                                           // of planner nav2; empty: default
  std::optional<nav2::Distro> nav2Distro;                         // none: detected from the file
  std::string nav2Topics;                                         // messages and calls, by time
  std::vector<std::pair<std::string, std::string>> nav2Values;  // override values of the file; YAML
  Pose2 start;
  std::vector<Vec2> goals;                   // in order; empty: the robot does not move
  std::vector<int> goalIds;                  // ids of `goals`; 0: a plain point
  double goalRadius = 0.2, startTime = 0.0;  // [m], [s]
  double radius = 0.35, mass = 50.0;         // [m], [kg]
  // [m/s], [m/s²], [rad/s], [rad/s²]
  double maxVel = 1.0, maxAcc = 1.0, maxOmega = 1.5, maxAlpha = 3.0;
  double maxReverse = 1.0;      // backwards [m/s]; scaled with maxVel as for the robot type
  std::vector<Vec2> footprint;  // robot frame, CCW; empty: disc
  Kinematics kinematics = Kinematics::Differential;
  double turningRadius = 0.0;  // Ackermann: minimum [m]
  LidarParameters lidar;       // no beams: no lidar
  bool recordsScans = false;
  DetectorKind detectorKind = DetectorKind::Sensor;
  DetectorParameters detector = idealDetector();
  OdometryParameters odometry;
  LocalizationParameters localization;
  BatteryParameters battery;
};

/// Applies the configuration modes and draws force factors and reactions by (seed, agent,
/// parameter); identical on every machine.
ResolvedHuman resolveHuman(const Environment& scenario, const Human& human, long long seed);
ResolvedRobot resolveRobot(const Scenario& scenario, const Robot& robot, int id);
/// The values of a robot type; those of the generic one for an unknown name.
ResolvedRobot robotOfType(const std::string& type);

/// Keys of `behavior` that the reaction of this type needs; empty without a reaction.
std::vector<std::string_view> reactionKeys(BehaviorType type);
const std::vector<std::string_view>& factorKeys();  // force factors of any behaviour

/// The numeric parameters that the scenario gives for a pedestrian model.
std::vector<std::pair<std::string, double>> modelParametersOf(const Environment& scenario,
                                                              const std::string& model);

/// Typical values of a kind, for agents that the program creates (brush, source). Free speeds are
/// normally distributed, clamped to `slowest` and `fastest`.
struct KindProfile {
  double mass = 80.0;                         // [kg]
  double radius = 0.35;                       // [m]
  double meanSpeed = 1.34, deviation = 0.26;  // [m/s]
  double slowest = 0.6, fastest = 2.1;        // [m/s]
};
const KindProfile& profileOf(PersonKind kind);
/// Depends only on seed and agent [m/s].
double sampleSpeed(PersonKind kind, long long seed, int person);

double massOf(PersonKind kind);  // [kg]
const char* personKindName(PersonKind kind);

}  // namespace sim2d
