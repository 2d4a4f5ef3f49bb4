#pragma once

#include <string_view>

#include "sim2d/nav/Battery.h"
#include "sim2d/nav/Lidar.h"
#include "sim2d/nav/Localization.h"
#include "sim2d/nav/Odometry.h"
#include "sim2d/nav/PeopleDetector.h"
#include "sim2d/scenario/Scenario.h"

namespace sim2d {

/// What counts for a person when keys are absent, presets and kinds applied, nothing sampled yet.
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
  // ours
  double startTime = 0.0;     // [s]
  double reactionTime = 1.0;  // factor of the model's relaxation time
  bool isVaried = false;      // drawn for this seed, see Variation.h
  std::string model = "sfm";
  std::vector<std::pair<std::string, double>> modelParameters;  // of it, as far as they are given
  std::vector<double> wait;
};

struct ResolvedRobot {
  int id = -1;
  std::string name, type = "generic", planner = "pursuit";
  std::string command;                                            // of planner external
  std::vector<std::pair<std::string, double>> plannerParameters;  // those that are numbers
  std::vector<std::pair<std::string, std::string>> plannerTexts;  // all of them, as text
  std::vector<std::string> nav2Params;                            // of planner nav2; empty: its own
  std::string nav2Tree;                                           // idem
  std::optional<nav2::Distro> nav2Distro;                         // none: as the file tells
  std::string nav2Topics;                                         // messages and calls, by time
  std::vector<std::pair<std::string, std::string>>
      nav2Values;  // values instead of the file's, as YAML
  Pose2 start;
  std::vector<Vec2> goals;   // points in order; empty: it stands
  std::vector<int> goalIds;  // beside them; 0 = a plain point
  double goalRadius = 0.2, startTime = 0.0;
  double radius = 0.35, mass = 50.0;
  double maxVel = 1.0, maxAcc = 1.0, maxOmega = 1.5, maxAlpha = 3.0;
  double maxReverse = 1.0;      // backwards [m/s]; as much less than maxVel as the type's
  std::vector<Vec2> footprint;  // robot frame, CCW; empty = disc
  Kinematics kinematics = Kinematics::Differential;
  double turningRadius = 0.0;  // Ackermann: the least [m]
  LidarParameters lidar;       // no beams: it has none
  bool recordsScans = false;
  DetectorKind detectorKind = DetectorKind::Sensor;
  DetectorParameters detector = idealDetector();
  OdometryParameters odometry;
  LocalizationParameters localization;
  BatteryParameters battery;
};

/// The configuration modes and draws of social-force factors and reactions, by (seed, agent,
/// parameter): the same on every machine.
ResolvedHuman resolveHuman(const Environment& scenario, const Human& human, long long seed);
ResolvedRobot resolveRobot(const Scenario& scenario, const Robot& robot, int id);
/// The numbers of a type of robots; those of the general one when there is none of this name.
ResolvedRobot robotOfType(const std::string& type);

/// Keys of `behavior` that a reaction of this type needs; none without a reaction.
std::vector<std::string_view> reactionKeys(BehaviorType type);
const std::vector<std::string_view>& factorKeys();  // idem, of every behaviour

/// The numbers that the scenario gives for a pedestrian model.
std::vector<std::pair<std::string, double>> modelParametersOf(const Environment& scenario,
                                                              const std::string& model);

/// What people of a kind are like: values for people that the program makes (brush, source). The
/// free speeds are normal, cut at both ends.
struct KindProfile {
  double mass = 80.0;                         // [kg]
  double radius = 0.35;                       // [m]
  double meanSpeed = 1.34, deviation = 0.26;  // [m/s]
  double slowest = 0.6, fastest = 2.1;        // [m/s]
};
const KindProfile& profileOf(PersonKind kind);
/// Drawn by (seed, person) alone [m/s].
double sampleSpeed(PersonKind kind, long long seed, int person);

double massOf(PersonKind kind);  // [kg]
const char* personKindName(PersonKind kind);

}  // namespace sim2d
