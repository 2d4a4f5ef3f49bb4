#pragma once

#include <string>

#include "sim2d/base/yaml/YamlMap.h"
#include "sim2d/scenario/FieldTables.h"
#include "sim2d/scenario/Scenario.h"

/// Reading of the node `hunav_loader`, and what older dialects meant. Private to this folder.
namespace sim2d {

using base::kNotNegative;
using base::kPositive;
using base::Range;
using base::ReadReport;
using base::YamlMap;
using base::YamlNode;

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

/// A map that could be an agent's block.
bool looksLikeAgent(const YamlNode& block);

Human readHuman(const YamlNode& block, bool listed, LoaderReading& reading);

/// Word, or number of the older dialects; anything else counts as Regular and is kept as text.
void setBehaviorType(Behavior& behavior, const std::string& text);

/// Tells of a type that is none of HuNavSim's.
void warnForeign(const Behavior& behavior, const YamlNode& at, const std::string& path,
                 EntityId entity, ReadReport& report);

/// Dialect A had a number and no parameters: what the program of that time did, as parameters.
void convertFromA(Human& human, const YamlNode& at, ReadReport& report);
/// Dialect B: `dist` had another meaning for some types, configuration 0 overruled the file.
void convertFromB(Human& human, const YamlNode& at, ReadReport& report);

}  // namespace sim2d
