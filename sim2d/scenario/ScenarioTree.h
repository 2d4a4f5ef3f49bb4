#pragma once

#include <set>
#include <string>

#include "sim2d/base/Ranges.h"
#include "sim2d/base/yaml/YamlMap.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/nav/RobotTypes.h"
#include "sim2d/scenario/Fields.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/scenario/ScenarioFile.h"

/// A scenario to and from the tree of its file, and what older dialects meant. Private to this
/// folder.
namespace sim2d {

using base::Range;
using base::ReadReport;
using base::scalarNode;
using base::stringNode;
using base::YamlMap;
using base::YamlNode;

constexpr const char* kLoaderNode = "hunav_loader";
constexpr const char* kBlockNode = "hunavsim_desktop";
constexpr const char* kParameters = "ros__parameters";
constexpr int kBlockFormat = 1;

// The tables, one function each, and reading and writing by them.
Fields<ScenarioSettings> scenarioFields();
Fields<Human> humanFields();
Fields<Behavior> behaviorFields();
Fields<PersonExtension> personFields();
Fields<Robot> robotFields();
Fields<LidarSettings> lidarFields();
Fields<DetectorSettings> detectorFields();
Fields<OdometrySettings> odometryFields();
Fields<LocalizationSettings> localizationFields();
Fields<BatterySettings> batteryFields();
Fields<Obstacle> obstacleFields();
Fields<Door> doorFields();
Fields<Area> areaFields();
Fields<Dock> dockFields();
Fields<DesktopSettings> settingsFields();
Fields<VariationSettings> variationFields();
Fields<MetricsSettings> metricsFields();

/// The value of one key, checked by its type and range; what is wrong with it is reported.
ParameterValue readValue(YamlMap& view, const ParameterSpec& spec, bool isWide);
/// Nothing is written for monostate.
void writeValue(YamlNode& tree, const ParameterSpec& spec, const ParameterValue& value, int digits);

template <class T>
void readFields(YamlMap& view, T& to, const FieldTables& tables) {
  for (const Field<T>& field : fieldsOf<T>(tables)) {
    if (field.belongsTo(to) && field.read) {
      field.read(view, to);
    } else if (field.belongsTo(to)) {
      const bool isMissing = field.required && !view.demand(field.spec.key);  // told
      field.assign(to, isMissing ? ParameterValue() : readValue(view, field.spec, field.isWide));
    }
  }
}

/// The keys of the table, and as text those that nobody knows.
template <class T>
void readThing(YamlMap view, T& to, const FieldTables& tables) {
  readFields(view, to, tables);
  to.unknown = view.takeUnknown();
}

template <class T>
void writeFields(YamlNode& tree, const T& of, const FieldTables& tables) {
  for (const Field<T>& field : fieldsOf<T>(tables)) {
    if (field.belongsTo(of) && field.write) {
      field.write(tree, of);
    } else if (field.belongsTo(of)) {
      const int digits = field.digitsOf ? field.digitsOf(of) : field.digits;
      writeValue(tree, field.spec, field.value(of), digits);
    }
  }
}

/// The state of one reading of hunav_loader.
struct LoaderReading {
  Scenario& scenario;
  ReadReport& report;
  const FieldTables& tables;
  bool scalarBehavior = false;   // dialect A
  bool numberedType = false;     // dialect B
  bool namedGoals = false;       // dialects A, B
  bool undefinedNumber = false;  // a goal number that global_goals lacks

  /// Numbers a goal that an agent had under a name of its own.
  int addGoal(const Vec2& position, UnknownKeys unknown, const YamlNode& at);
  EntityId newEntity(base::EntityKind kind, const YamlNode& at);

  int lastKey = 0;
  std::size_t goalsSeen = 0;  // of the scenario
  int largestGoal = 0;        // among them
};

/// The lidar of a type; of the general one, without beams, when it has none.
void takeLidarOf(const RobotType& type, ResolvedRobot& to);
/// What the file says beyond that.
void resolveSensors(const Robot& from, ResolvedRobot& to);

/// A map that could be an agent's block.
bool looksLikeAgent(const YamlNode& block);

Human readHuman(const YamlNode& block, bool listed, LoaderReading& reading);

/// Word, or number of the older dialects; anything else counts as Regular and is kept as text.
void setBehaviorType(Behavior& behavior, const std::string& text);

/// Tells of a type that is none of HuNavSim's.
void warnForeign(const Behavior& behavior, const YamlNode& at, const std::string& key,
                 YamlMap& view);

struct TreeReading {
  ScenarioReading file;
  std::set<std::string> loaderPaths, blockPaths;  // keys that exist, below ros__parameters
};

TreeReading readTree(const YamlNode& root, const std::string& fileName,
                     const FieldTables& tables = fieldTables());
YamlNode fileTree(const Scenario& scenario, const FieldTables& tables = fieldTables());

/// Reads the parameters of our block into `reading.scenario`.
void readBlock(const YamlNode& parameters, LoaderReading& reading);

const std::vector<std::string>& routeWords();

/// Keys of each node: names that are taken.
const std::set<std::string>& loaderKeys();
const std::set<std::string>& blockKeys();
/// A name that robots, obstacles, doors and areas may have.
bool isEntityName(const std::string& name);

// Nodes for the writer.
YamlNode decimals(double value, int digits = 1);
YamlNode number(long long value);
YamlNode flag(bool value);
YamlNode decimalList(const std::vector<double>& values);
void setChild(YamlNode& map, const std::string& key, YamlNode value);
YamlNode integerList(const std::vector<int>& values);
void setPoint(YamlNode& map, const Vec2& point, int digits = 1);  // x, y
void setUnknown(YamlNode& map, const UnknownKeys& unknown);

Vec2 readPoint(YamlMap& view);  // x, y
/// A map of names and single values.
ParameterTexts readParameters(YamlMap& view, const std::string& key);
void writeParameters(YamlNode& tree, const std::string& key, const ParameterTexts& parameters);
void readVariation(YamlMap& view, DesktopSettings& to);
void writeVariation(YamlNode& tree, const DesktopSettings& desktop);
/// Maps inside an entity that have no place for keys of others.
void refuseUnknown(YamlMap& view);

/// Calls `visit` with each list of things that have a map in our block: its key there, its kind.
template <class S, class Visit>
void forEachBlockList(S& scenario, Visit visit) {
  visit("robots", base::EntityKind::Robot, scenario.robots);
  visit("obstacles", base::EntityKind::Obstacle, scenario.obstacles);
  visit("doors", base::EntityKind::Door, scenario.doors);
  visit("areas", base::EntityKind::Area, scenario.areas);
  visit("docks", base::EntityKind::Dock, scenario.docks);
}

/// The keys of one thing, those that we do not know last; null when there are none.
template <class T>
YamlNode fieldTree(const T& of, const FieldTables& tables) {
  YamlNode tree;
  writeFields(tree, of, tables);
  setUnknown(tree, of.unknown);
  return tree;
}

}  // namespace sim2d
