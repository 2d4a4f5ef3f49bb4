#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"

namespace sim2d {

enum class ExportTarget { GazeboClassic, GazeboFortress, Isaac, Webots, Native };

/// Requirements of a simulator's wrapper package.
struct TargetInfo {
  ExportTarget target = ExportTarget::Native;
  std::string name;     // on the command line: "gazebo-classic"
  std::string title;    // for users, and value of the key `simulator`: "Gazebo Classic"
  std::string package;  // ROS package; empty for native
  std::string launch;   // launch file; empty: started by another program
  Dialect dialect = Dialect::C;
  std::optional<double> startHeight;  // z of init_pose [m]
  std::vector<std::string> worlds;    // its 3-D worlds

  std::string startCommand(const Scenario& scenario) const;  // empty for native
  bool hasWorld(const std::string& map) const;               // among its own worlds
  std::string robotStart(const Scenario& scenario) const;    // arguments of startCommand
  /// Warnings about the world that startCommand uses if the scenario has no map, or one that is not
  /// among its worlds.
  base::Diagnostic worldWithoutMap() const;
  base::Diagnostic worldOfMap(const std::string& map) const;
};
const std::vector<TargetInfo>& exportTargets();
/// Null: unknown name.
const TargetInfo* exportTarget(const std::string& name);

struct ExportOptions {
  std::optional<Dialect> dialect;  // B or C; none: that of the target
  std::string baseName;            // file name of the scenario; becomes yaml_base_name
  std::string mapName;             // name of the map file in ../maps; empty: none
};

struct ExportedScenario {
  Scenario scenario;          // as written to the file
  std::string text;           // content of the file
  std::map<int, int> goals;   // old to new number, all goals
  std::map<int, int> people;  // old to new id, all agents
  base::Diagnostics report;   // changes, and what the target cannot express
  std::string startCommand;   // empty for native
};

/// Converts a scenario for the target: dialect, simulator and start height, ids 1…N in list order,
/// goals numbered without gaps, at least one goal per agent, safe names, all keys that the wrapper
/// requires, factors and skins in its range. Does not access files.
ExportedScenario exportScenario(const Scenario& scenario, const TargetInfo& target,
                                const ExportOptions& options);

/// Letters, digits and underscores, beginning with a letter: valid as the name of a model or file.
std::string safeName(const std::string& name);

/// Goal numbers of an export. Private to this folder.

using GoalNumbers = std::map<int, int>;  // old to new

/// 1 … N in the order of the old numbers.
GoalNumbers contiguousGoalNumbers(const Scenario& scenario);

/// Dialect B names the goals of each agent without numbers. Its readers number them agent by agent,
/// after the goals that no agent uses. A goal in several lists gets its first number.
GoalNumbers dialectBGoalNumbers(const Scenario& scenario);

/// Applies the new numbers to goals, agents and robots, and sorts the goals.
void renumberGoals(Scenario& scenario, const GoalNumbers& numbers);

/// Applies `first`, then `second`.
GoalNumbers composed(const GoalNumbers& first, const GoalNumbers& second);

}  // namespace sim2d
