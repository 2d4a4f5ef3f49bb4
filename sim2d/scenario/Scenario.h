#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Types.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

/// The scenario as written in a file: plain values, compared by content (without EntityIds, which
/// identify objects within one document). Absent keys are nullopt and are not written;
/// ResolvedValues.h has the effective values. World frame, SI units, radians.
namespace sim2d {

using base::EntityId;
using base::Pose2;
using base::UnknownKey;
using base::UnknownKeys;
using base::Vec2;

enum class Dialect { A, B, C };  // 2022-2023, 2024 to mid 2025, HuNavSim 2.0
enum class BehaviorType { Regular = 1, Impassive, Surprised, Scared, Curious, Threatening };
enum class Configuration { Default = 0, Custom = 1, Normal = 2, Uniform = 3 };

const char* behaviorName(BehaviorType type);                            // "Regular" …
std::optional<BehaviorType> behaviorFromName(const std::string& word);  // ignores case
inline bool reactsToRobot(BehaviorType type) {
  return type != BehaviorType::Regular && type != BehaviorType::Impassive;
}
/// Whether force factors and reactions are drawn.
inline bool isDrawn(Configuration configuration) {
  return configuration == Configuration::Normal || configuration == Configuration::Uniform;
}

/// An object with a name and a block of its own in the file.
struct NamedEntity {
  EntityId key;
  std::string name;    // unique
  bool listed = true;  // false: the block exists but is switched off
  UnknownKeys unknown;
};

struct GlobalGoal {
  EntityId key;
  int id = 0;                    // >= 1
  Vec2 position = Vec2::Zero();  // [m]
  UnknownKeys unknown;
};

/// The `behavior` map of an agent. Distances [m], duration [s], vel [m/s].
struct Behavior {
  std::optional<BehaviorType> type;
  std::string unknownType;  // the original text of an unknown type (`type` is Regular then)
  std::optional<Configuration> configuration;
  std::optional<double> dist;  // the robot is noticed within
  std::optional<double> duration;
  std::optional<bool> once;
  std::optional<double> vel;           // while reacting
  std::optional<double> safeDistance;  // scared
  std::optional<double> stopDist;      // curious
  std::optional<double> frontDist;     // threatening
  std::optional<double> goalForceFactor, obstacleForceFactor, socialForceFactor, otherForceFactor;
  UnknownKeys unknown;
};

enum class PersonKind { Adult, Child, Elderly, Wheelchair, Luggage };
enum class Route { Planned, Direct };
enum class AtEnd { Stop, Leave, Restart };

/// Keys of an agent in the node `hunavsim_desktop`.
struct PersonExtension {
  std::optional<double> startTime;  // [s]
  std::optional<PersonKind> kind;
  std::optional<double> mass;  // [kg]
  std::optional<std::string> model;
  std::optional<Route> route;
  std::optional<AtEnd> atEnd;
  std::vector<double> wait;         // [s], one per goal, or empty
  std::optional<std::string> tree;  // relative to the scenario
  UnknownKeys unknown;
};

struct Human : NamedEntity {
  int id = -1;                 // >= 0, unique
  std::optional<int> groupId;  // -1 = alone
  std::optional<int> skin;
  std::optional<double> maxVel;      // v0 [m/s]
  std::optional<double> radius;      // r [m]
  std::optional<double> goalRadius;  // rho [m]
  std::optional<bool> cyclicGoals;
  Pose2 initPose;
  bool hasInitPose = true;
  std::optional<double> initZ;  // [m], not used in 2-D
  UnknownKeys initPoseUnknown;
  Behavior behavior;
  std::vector<int> goals;  // ids of global goals in visiting order
  PersonExtension ours;
};

struct RobotGoal {  // at most one is set
  std::optional<Vec2> point;
  std::vector<int> goals;  // ids of global goals, in order
};

/// Parameters of a planner or model by name: YAML scalars as text.
using ParameterTexts = std::vector<std::pair<std::string, std::string>>;

/// The `lidar` of a robot; absent keys default to its type. x, y: sensor position, robot frame.
struct LidarSettings {
  std::optional<int> beams;                           // 0: no lidar
  std::optional<double> range, rate;                  // [m], [Hz]
  std::optional<double> angleMin, angleMax, x, y, h;  // [rad], [m]
  std::optional<double> noise;                        // [m]
  std::optional<bool> legs, record;
  UnknownKeys unknown;
};

enum class DetectorKind { Sensor, GroundTruth };
enum class TrackVelocities { Measured, Filtered };

/// The `detector` of a robot: perception of people and other robots.
struct DetectorSettings {
  std::optional<DetectorKind> kind;
  std::optional<double> range, field, rate, latency, noise, misses, swaps, swapDistance;
  std::optional<bool> occlusion;
  std::optional<double> maxOcclusion, coastTime;
  std::optional<TrackVelocities> velocities;
  std::optional<double> accelerationNoise;
  UnknownKeys unknown;
};

/// The `odometry_noise` of a robot.
struct OdometrySettings {
  std::optional<double> alpha1, alpha2, alpha3, alpha4, drift;
  UnknownKeys unknown;
};

/// The `localization` of a robot.
struct LocalizationSettings {
  std::optional<double> stdX, stdY, stdYaw, correlationTime, jumpRate, jumpDistance, jumpYaw, rate;
  std::optional<double> startX, startY, startYaw, initialPoseTime, globalStd, globalStdYaw;
  UnknownKeys unknown;
};

/// The `battery` of a robot; without capacity it is never empty.
struct BatterySettings {
  std::optional<double> capacity;                   // [Wh]
  std::optional<double> level;                      // initial charge, 0 to 1
  std::optional<double> idlePower, motionPower;     // [W]
  std::optional<double> chargePower;                // [W], at a charging dock
  std::optional<double> emptyVoltage, fullVoltage;  // [V]
  UnknownKeys unknown;
};

struct Robot : NamedEntity {
  std::optional<std::string> type, planner;
  std::optional<std::string> command;  // the program of planner `external`
  ParameterTexts plannerParameters;
  std::vector<std::string> nav2Params;  // of planner `nav2`: files and `name:=value`, in order
  std::optional<std::string> nav2Tree;  // of planner `nav2`: a file
  std::optional<bool> nav2Body;         // of planner `nav2`: uses the body of its parameter files
  std::optional<nav2::Distro> nav2Distro;
  std::optional<std::string> nav2Topics;  // messages published to Nav2
  ParameterTexts nav2Values;              // override the file: "FollowPath.temperature"
  Pose2 start;
  RobotGoal goal;
  std::optional<double> goalRadius, startTime, radius, mass, maxVel, maxAcc, maxOmega, maxAlpha;
  std::vector<double> footprintX, footprintY;  // robot frame, counter-clockwise
  std::optional<Kinematics> kinematics;
  std::optional<double> turningRadius;  // [m]
  LidarSettings lidar;
  DetectorSettings detector;
  OdometrySettings odometryNoise;
  LocalizationSettings localization;
  BatterySettings battery;
};

enum class ObstacleKind { Box, Circle, Polygon, Wall };
struct Obstacle : NamedEntity {
  ObstacleKind kind = ObstacleKind::Box;
  Pose2 pose;                        // box: centre and heading; circle: centre
  double length = 1.0, width = 1.0;  // box
  double radius = 0.5;               // circle
  std::vector<Vec2> points;          // polygon, wall
  std::optional<double> thickness;   // wall, 0.1
};

struct Door : NamedEntity {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  std::optional<double> thickness;  // 0.05
  std::optional<bool> open;         // true
  std::vector<double> toggles;      // [s]
};

enum class AreaKind { Source, Sink, Wait, Exit, Speed };
struct Area : NamedEntity {
  AreaKind kind = AreaKind::Wait;
  std::vector<Vec2> points;
  std::optional<std::string> like;  // source: name of the agent to copy
  std::optional<double> rate;       // [1/s]
  std::optional<double> from, until;
  std::optional<int> count;
  std::optional<double> factor;        // speed: of the desired speed of people
  std::optional<double> carrySpeed;    // speed: of a travelator [m/s]
  std::optional<double> carryHeading;  // speed: its direction [rad]
};

enum class DockKind { Charging, Parking };
/// A dock: the pose of a robot that has docked forwards.
struct Dock : NamedEntity {
  DockKind kind = DockKind::Charging;
  Pose2 pose;
};

/// Key `metrics` of the block. `from`, `until`: as written ("goal", "time 5.0", "event contact").
struct MetricsSettings {
  std::optional<std::string> from, until;
  std::optional<double> frequency;
  std::optional<std::string> tag;
  std::optional<int> runId;
  std::optional<std::string> file;
  std::vector<std::pair<std::string, double>> parameters;
  UnknownKeys unknown;
};

enum class VariationPreset { None, Light, Strong };
enum class SpreadKind { None, Normal, Uniform };
/// Quantities of an agent that vary with the seed. The numbers are part of each draw.
enum class VariationQuantity { StartTime, Start, Heading, Speed, ReactionTime, FirstGoal };
constexpr std::size_t kVariedCount = 6;

/// Distribution of one quantity, in its unit; defaults for absent values: see Variation.h.
struct SpreadSettings {
  std::optional<SpreadKind> kind;
  std::optional<double> sd, halfWidth, min, max;
  UnknownKeys unknown;
};

/// Key `variation` of the block: agents are drawn for each seed.
struct VariationSettings {
  std::optional<VariationPreset> preset;
  std::array<SpreadSettings, kVariedCount> spreads;  // index: VariationQuantity
  UnknownKeys unknown;

  SpreadSettings& of(VariationQuantity quantity) {
    return spreads[static_cast<std::size_t>(quantity)];
  }
  const SpreadSettings& of(VariationQuantity quantity) const {
    return spreads[static_cast<std::size_t>(quantity)];
  }
};

enum class Difficulty { Easy, Normal, Hard };
/// Key `card` of the block: what the scenario tests. It does not change a run.
struct ScenarioCard {
  std::optional<std::string> title;      // name for people: "Blind corner"
  std::optional<std::string> family;     // group of scenarios that it belongs to
  std::optional<std::string> purpose;    // what it tests
  std::optional<std::string> robotTask;  // what the robot has to do
  std::optional<std::string> people;     // what people do
  std::optional<std::string> outcome;    // what a good robot does
  std::vector<std::string> metrics;      // keys of metrics to read, the most important one first
  std::optional<Difficulty> difficulty;
  std::optional<std::string> source;  // citation
  std::optional<std::string> licence;
  std::vector<std::string> expect;  // what happens without a robot, see Expectation.h
  UnknownKeys unknown;
};

enum class ObstaclePoints { Boundary, Rays };
/// Contacts of a moving robot that end the run: with people, or with any solid object.
enum class StopOnCollision { None, People, Any };

/// Keys of the block `hunavsim_desktop` itself.
struct DesktopSettings {
  std::optional<std::string> mapFile;
  std::optional<std::string> mapRule;  // "humble", "main"
  std::optional<long long> seed;
  std::optional<double> duration, dt;  // [s]
  std::optional<StopOnCollision> stopOnCollision;
  std::optional<double> stuckAfter;  // [s], 0 = never
  std::optional<int> recordEvery;
  std::optional<std::string> model;
  std::vector<std::pair<std::string, ParameterTexts>> modelParameters;  // by model
  std::optional<Route> route;
  std::optional<ObstaclePoints> obstaclePoints;
  std::optional<bool> loopTrees;
  std::vector<double> wrapX;                        // empty or 2
  std::vector<std::pair<int, std::string>> groups;  // number and name
  ScenarioCard card;
  VariationSettings variation;
  MetricsSettings metrics;
  UnknownKeys unknown;
};

/// Keys of the scenario itself.
struct ScenarioSettings {
  std::optional<std::string> yamlBaseName, simulator, map;
  std::optional<bool> publishPeople;
  DesktopSettings desktop;
};

/// A scenario without its agents: the part that a running world keeps.
struct Environment : ScenarioSettings {
  std::vector<GlobalGoal> goals;    // in file order
  std::vector<Robot> robots;        // listed first; they have the ids -1, -2 …
  std::vector<Obstacle> obstacles;  // listed first
  std::vector<Door> doors;
  std::vector<Area> areas;
  std::vector<Dock> docks;
  UnknownKeys unknown;     // unknown global keys of hunav_loader
  UnknownKeys otherNodes;  // other nodes of the file
};

struct Scenario : Environment {
  std::vector<Human> humans;  // listed ones in list order, then the others

  const GlobalGoal* goal(int id) const;
  const Human* human(const std::string& name) const;
  const Human* humanById(int id) const;
  /// A key that no entity of this scenario uses.
  int nextKey() const;
};

/// Calls visit(kind, member of Scenario) for each list of entities.
template <class Visit>
void forEachKind(Visit visit) {
  visit(base::EntityKind::Human, &Scenario::humans);
  visit(base::EntityKind::Goal, &Scenario::goals);
  visit(base::EntityKind::Robot, &Scenario::robots);
  visit(base::EntityKind::Obstacle, &Scenario::obstacles);
  visit(base::EntityKind::Door, &Scenario::doors);
  visit(base::EntityKind::Area, &Scenario::areas);
  visit(base::EntityKind::Dock, &Scenario::docks);
}

/// Calls visit(kind, list) for each list of entities.
template <class S, class Visit>
void forEachList(S& scenario, Visit&& visit) {
  forEachKind([&](base::EntityKind kind, auto list) { visit(kind, scenario.*list); });
}

/// Calls visit for each listed object.
template <class T, class Visit>
void forEachListed(const std::vector<T>& all, Visit visit) {
  for (const T& each : all) {
    if (each.listed) {
      visit(each);
    }
  }
}

/// Compares content; for all types that keep unknown keys.
template <class T>
auto operator==(const T& a, const T& b) -> decltype(a.unknown == b.unknown);
bool operator==(const ScenarioSettings& a, const ScenarioSettings& b);
template <class T>
auto operator!=(const T& a, const T& b) -> decltype(a.unknown == b.unknown) {
  return !(a == b);
}

}  // namespace sim2d
