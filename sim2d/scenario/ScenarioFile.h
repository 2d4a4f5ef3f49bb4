#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"

namespace sim2d {

struct FieldTables;  // Fields.h
const FieldTables& fieldTables();

/// What reading gives. With errors among the diagnostics the scenario holds what could be read
/// (for an editor to show) and must not be run.
struct ScenarioReading {
  Scenario scenario;
  base::Diagnostics diagnostics;
  Dialect dialect = Dialect::C;
  bool hasBlock = false;                 // hunavsim_desktop: this program knows the scenario
  int commentCount = 0;                  // lost when saved over
  std::map<EntityId, int> lines;         // where each entity's block begins
  int agentsLine = 0, agentsColumn = 0;  // of the key of the list of people; 0: there is none
  bool ok() const { return !base::hasErrors(diagnostics); }
};

ScenarioReading readScenario(const std::string& path);
ScenarioReading readScenarioText(const std::string& text, const std::string& fileName);
/// For an editor, when readScenario gives nothing because the syntax breaks: the same diagnostics,
/// and what stands before that place. Never to be run or written over the file.
ScenarioReading readBeginning(const std::string& path);

/// Gives diagnostics about an entity that have no line the line of its block, and those with a line
/// the file `path` and the column at which the line's key begins there.
void addPlaces(base::Diagnostics& diagnostics, const std::map<EntityId, int>& lines,
               const std::string& path);

/// Gives what is said about the file `path` without a line the place of the first of these keys
/// that is there, dotted from the top: "hunav_loader.ros__parameters.map".
void addPlaceOfKey(base::Diagnostics& diagnostics, const std::string& path,
                   const std::vector<std::string>& keys);

/// The same for what `findMap` says of the scenario in the file `path`: the key that names the map.
void addPlaceOfMap(base::Diagnostics& diagnostics, const std::string& path);

/// The scenario without the keys of our block that stand at their default, as a file holds it:
/// readScenarioText(writeScenario(s)) gives withoutDefaults(s).
Scenario withoutDefaults(Scenario scenario, const FieldTables& tables = fieldTables());

/// What the wrapper probably was, by the start heights; for files that do not say (dialects A, B).
std::optional<std::string> suggestedSimulator(const Scenario& scenario);

/// Canonical dialect C plus our block (FORMAT.md). A file without the block ends without a newline,
/// as HuNavSim's own editor writes it; with the block it ends with one.
std::string writeScenario(const Scenario& scenario);
/// Goals that are in no person's list, in the order of the scenario.
std::vector<GlobalGoal> goalsOfNobody(const Scenario& scenario);
/// Dialect B for the older wrappers; what it cannot express is told in `losses`. Goals of nobody
/// are global_goals as in C: HuNavSim passes over keys that it does not know.
std::string writeScenarioB(const Scenario& scenario, base::Diagnostics& losses);

/// `--set PATH=VALUE` (FORMAT.md): dotted keys below ros__parameters; `*` = every listed person.
base::Diagnostics setValue(Scenario& scenario, const std::string& path, const std::string& value,
                           const FieldTables& tables = fieldTables());

}  // namespace sim2d
