#pragma once

#include <set>
#include <string>

#include "sim2d/base/Ranges.h"
#include "sim2d/base/yaml/YamlMap.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/nav/RobotTypes.h"
#include "sim2d/scenario/Fields.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"

/// Conversion between a scenario and the YAML tree of its file, including older dialects, and the
/// parts of its check. Private to this folder.
namespace sim2d {

using base::Range;
using base::ReadReport;
using base::scalarNode;
using base::stringNode;
using base::YamlMap;
using base::YamlNode;

constexpr const char* kLoaderNode = "hunav_loader";
constexpr const char* kDesktopNode = "hunavsim_desktop";
constexpr const char* kParameters = "ros__parameters";
constexpr int kDesktopFormat = 1;

// The field tables, and reading and writing with them.
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
Fields<ScenarioCard> cardFields();
Fields<VariationSettings> variationFields();
Fields<MetricsSettings> metricsFields();

/// Reads one key; problems with its type or range are reported.
ParameterValue readValue(YamlMap& view, const ParameterSpec& spec, bool is64Bit);
/// monostate is not written.
void writeValue(YamlNode& tree, const ParameterSpec& spec, const ParameterValue& value, int digits);

template <class T>
void readFields(YamlMap& view, T& to, const FieldTables& tables) {
  for (const Field<T>& field : fieldsOf<T>(tables)) {
    if (field.belongsTo(to) && field.read) {
      field.read(view, to);
    } else if (field.belongsTo(to)) {
      const bool isMissing = field.required && !view.requireKey(field.spec.key);  // reported
      field.assign(to, isMissing ? ParameterValue() : readValue(view, field.spec, field.is64Bit));
    }
  }
}

/// Reads the keys of the table; unknown keys are kept as text.
template <class T>
void readObject(YamlMap view, T& to, const FieldTables& tables) {
  readFields(view, to, tables);
  to.unknown = view.takeUnknownKeys();
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

/// State while reading hunav_loader.
struct LoaderReading {
  Scenario& scenario;
  ReadReport& report;
  const FieldTables& tables;
  bool hasScalarBehavior = false;  // dialect A
  bool hasNumberedType = false;    // dialect B
  bool hasNamedGoals = false;      // dialects A, B
  bool hasUndefinedGoal = false;   // a goal number is not in global_goals

  /// Adds a goal that was defined in an agent's block, and numbers it.
  int addGoal(const Vec2& position, UnknownKeys unknown, const YamlNode& at);
  EntityId newEntity(base::EntityKind kind, const YamlNode& at);

  int lastKey = 0;
  std::size_t goalsSeen = 0;  // goals of the scenario scanned so far
  int largestGoal = 0;        // largest number among them
};

/// Sets the lidar of a robot type; the generic one without beams if the type has none.
void setLidarFromType(const RobotType& type, ResolvedRobot& to);
/// Applies the keys of the file.
void resolveSensors(const Robot& from, ResolvedRobot& to);

/// Whether a map may be the block of an agent.
bool looksLikeAgent(const YamlNode& block);

Human readHuman(const YamlNode& block, bool listed, LoaderReading& reading);

/// `text`: a name, or the number of older dialects. Other texts are kept and count as Regular.
void setBehaviorType(Behavior& behavior, const std::string& text);

/// Warns about a type that HuNavSim does not have.
void warnUnknownBehavior(const Behavior& behavior, const YamlNode& at, const std::string& key,
                         YamlMap& view);

struct TreeReading {
  ScenarioReading file;
  std::set<std::string> loaderPaths, desktopPaths;  // existing keys, below ros__parameters
};

TreeReading readTree(const YamlNode& root, const std::string& fileName,
                     const FieldTables& tables = fieldTables());
YamlNode fileTree(const Scenario& scenario, const FieldTables& tables = fieldTables());

/// Reads the parameters of hunavsim_desktop into `reading.scenario`.
void readDesktopNode(const YamlNode& parameters, LoaderReading& reading);

const std::vector<std::string>& routeWords();

/// Keys of each node, which cannot be used as names.
const std::set<std::string>& loaderKeys();
const std::set<std::string>& desktopKeys();
/// Whether the name is valid for robots, obstacles, doors, areas and docks.
bool isEntityName(const std::string& name);

// YAML nodes for the writer.
YamlNode decimals(double value, int digits = 1);
YamlNode number(long long value);
YamlNode flag(bool value);
YamlNode decimalList(const std::vector<double>& values);
void setChild(YamlNode& map, const std::string& key, YamlNode value);
YamlNode integerList(const std::vector<int>& values);
void setPoint(YamlNode& map, const Vec2& point, int digits = 1);  // x, y
void setUnknown(YamlNode& map, const UnknownKeys& unknown);

Vec2 readPoint(YamlMap& view);  // x, y
/// Reads a map of scalars.
ParameterTexts readParameters(YamlMap& view, const std::string& key);
void writeParameters(YamlNode& tree, const std::string& key, const ParameterTexts& parameters);
void readCard(YamlMap& view, DesktopSettings& to);
void writeCard(YamlNode& tree, const DesktopSettings& desktop);
void readVariation(YamlMap& view, DesktopSettings& to);
void writeVariation(YamlNode& tree, const DesktopSettings& desktop);
/// Warns about unknown keys of a map that cannot keep them.
void warnUnknownKeys(YamlMap& view);

/// Calls visit(key, kind, list) for each list of objects in hunavsim_desktop.
template <class S, class Visit>
void forEachEntityList(S& scenario, Visit visit) {
  visit("robots", base::EntityKind::Robot, scenario.robots);
  visit("obstacles", base::EntityKind::Obstacle, scenario.obstacles);
  visit("doors", base::EntityKind::Door, scenario.doors);
  visit("areas", base::EntityKind::Area, scenario.areas);
  visit("docks", base::EntityKind::Dock, scenario.docks);
}

/// The keys of an object, unknown ones last; null if there are none.
template <class T>
YamlNode objectTree(const T& of, const FieldTables& tables) {
  YamlNode tree;
  writeFields(tree, of, tables);
  setUnknown(tree, of.unknown);
  return tree;
}

// Shared parts of checkScenario.

/// The entity of a problem, and the prefix of its text: "anna", "anna: footprint", or none.
struct Subject {
  Subject(EntityId id, std::string place = {}) : entity(id), where(std::move(place)) {}  // NOLINT
  Subject(const NamedEntity& thing) : Subject(thing.key, thing.name) {}                  // NOLINT

  EntityId entity;
  std::string where;
};

struct CheckReport {
  std::string file;
  base::Diagnostics diagnostics;

  void add(base::Severity severity, const Subject& subject, std::string_view code,
           base::ProblemValues values = {});
  void error(const Subject& subject, std::string_view code, base::ProblemValues values = {}) {
    add(base::Severity::Error, subject, code, std::move(values));
  }
  void warning(const Subject& subject, std::string_view code, base::ProblemValues values = {}) {
    add(base::Severity::Warning, subject, code, std::move(values));
  }
};

void checkCard(const Scenario& scenario, CheckReport& report);
/// Warns about valid values that are far from those in the literature.
void checkPlausibility(const Scenario& scenario, CheckReport& report);
void checkShapes(const Scenario& scenario, CheckReport& report);
/// False: a coordinate is not finite or beyond a million metres, so paths cannot be planned.
bool checkCoordinates(const Scenario& scenario, CheckReport& report);
void checkPlaces(const Scenario& scenario, const Surroundings& surroundings, CheckReport& report);

}  // namespace sim2d
