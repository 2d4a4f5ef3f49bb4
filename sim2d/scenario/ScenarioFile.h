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

/// Result of reading. With errors the scenario contains what could be read (for display in an
/// editor) and must not be run.
struct ScenarioReading {
  Scenario scenario;
  base::Diagnostics diagnostics;
  Dialect dialect = Dialect::C;
  bool hasDesktopNode = false;           // the file has the node hunavsim_desktop
  int commentCount = 0;                  // comments are lost when the file is saved
  std::map<EntityId, int> lines;         // first line of each entity's block
  int agentsLine = 0, agentsColumn = 0;  // of the key `agents`; 0: there is none
  bool ok() const { return !base::hasErrors(diagnostics); }
};

ScenarioReading readScenario(const std::string& path);
ScenarioReading readScenarioText(const std::string& text, const std::string& fileName);
/// The card in the text of a scenario file, without reading the rest; for lists of many files. A
/// file that is not formatted as this program saves it is read completely.
ScenarioCard cardOf(const std::string& text);
/// For editors, if a syntax error prevents reading: the same diagnostics and the content before the
/// error. It must not be run or saved to the file.
ScenarioReading readValidPart(const std::string& path);

/// Adds line numbers to diagnostics: those about an entity get the line of its block, and all with
/// a line get the file `path` (another one moves into the message) and the column of that key.
void addLocations(base::Diagnostics& diagnostics, const std::map<EntityId, int>& lines,
                  const std::string& path);

/// Adds a place to diagnostics of the file `path` that have no line: that of the first existing key
/// of `keys`, given as dotted paths: "hunav_loader.ros__parameters.map".
void addKeyLocation(base::Diagnostics& diagnostics, const std::string& path,
                    const std::vector<std::string>& keys);

/// The same for diagnostics of `findMap`: the place of the key that names the map.
void addMapLocation(base::Diagnostics& diagnostics, const std::string& path);

/// The scenario without keys of hunavsim_desktop that equal their default, as stored in a file:
/// readScenarioText(writeScenario(s)) gives withoutDefaults(s).
Scenario withoutDefaults(Scenario scenario, const FieldTables& tables = fieldTables());

/// The probable simulator, by the start heights; for files that do not name it (dialects A, B).
std::optional<std::string> suggestedSimulator(const Scenario& scenario);

/// Canonical dialect C plus the node hunavsim_desktop (FORMAT.md). A file without that node ends
/// without a newline, as HuNavSim's editor writes it; otherwise with one.
std::string writeScenario(const Scenario& scenario);
/// Goals that no agent uses, in scenario order.
std::vector<GlobalGoal> unusedGoals(const Scenario& scenario);
/// Dialect B for older wrappers; `losses` lists what it cannot express. Goals that no agent uses
/// are written as global_goals, as in dialect C: HuNavSim ignores unknown keys.
std::string writeScenarioB(const Scenario& scenario, base::Diagnostics& losses);

/// `--set PATH=VALUE` (FORMAT.md): dotted keys below ros__parameters; `*` means every listed agent.
/// A map as the value of a whole entity sets each of its keys and leaves the others as they are.
base::Diagnostics setValue(Scenario& scenario, const std::string& path, const std::string& value,
                           const FieldTables& tables = fieldTables());

}  // namespace sim2d
