#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"

namespace sim2d {

enum class ExportTarget { GazeboClassic, GazeboFortress, Isaac, Webots, Native };

/// What a simulator's wrapper package expects.
struct TargetInfo {
  ExportTarget target = ExportTarget::Native;
  std::string name;     // on the command line: "gazebo-classic"
  std::string title;    // for people, and value of the key `simulator`: "Gazebo Classic"
  std::string package;  // of ROS; empty for native
  std::string launch;   // its file that starts a world; empty: another program does
  Dialect dialect = Dialect::C;
  std::optional<double> startHeight;  // z of init_pose [m]
  std::vector<std::string> worlds;    // 3-D worlds that come with it

  std::string startCommand(const Scenario& scenario) const;  // empty for native
  bool hasWorld(const std::string& map) const;               // among those that come with it
  std::string robotStart(const Scenario& scenario) const;    // arguments of that command
  /// Which world that command starts when the scenario has no map, or one that is none of its own.
  base::Diagnostic worldWithoutMap() const;
  base::Diagnostic worldOfMap(const std::string& map) const;
};
const std::vector<TargetInfo>& exportTargets();
/// Null for a name that is none.
const TargetInfo* exportTarget(const std::string& name);

struct ExportOptions {
  std::optional<Dialect> dialect;  // B or C; none: the target's
  std::string baseName;            // of the scenario file; becomes yaml_base_name
  std::string mapName;             // of the map file in ../maps; empty: there is none
};

struct ExportedScenario {
  Scenario scenario;          // as the file holds it
  std::string text;           // the file
  std::map<int, int> goals;   // old number -> new one, of all goals
  std::map<int, int> people;  // old id -> new one, of all people
  base::Diagnostics report;   // what was changed, what the target cannot express
  std::string startCommand;   // how to run it there; empty for native
};

/// A scenario as the target takes it: its dialect, simulator and start height, ids 1…N in list
/// order, goals without gaps, at least one goal for everybody, safe names, all keys that the
/// wrapper asks for, factors and skins in its range. Reads and writes no file.
ExportedScenario exportScenario(const Scenario& scenario, const TargetInfo& target,
                                const ExportOptions& options);

/// Letters, digits and underscores, beginning with a letter: usable as a model's or file's name.
std::string safeName(const std::string& name);

}  // namespace sim2d
