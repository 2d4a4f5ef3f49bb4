#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt/robot/Nav2Files.h"
#include "sim2d/nav/nav2/Nav2Key.h"
#include "sim2d/scenario/Scenario.h"

/// What planner `nav2` needs beside the scenario: files, and values that only they know of.
namespace app {

/// Shipped parameter files and trees.
bt::Nav2Folders shippedNav2();

/// Values given instead of those of a file (`nav2.FollowPath.temperature`) that no parameter fits.
/// Problems of the files are told where the world is made.
base::Diagnostics wrongNav2Values(const sim2d::Scenario& scenario, const std::string& scenarioPath);
/// The scenario as a world takes it: robots of `nav2` without a `goal_radius` have that of their
/// file's goal checker. `unread`: why it is not known; of a file that can be read by the time its
/// world is made, nobody else tells.
std::shared_ptr<const sim2d::Scenario> withNav2GoalRadius(
    const std::shared_ptr<const sim2d::Scenario>& scenario, const std::string& scenarioPath,
    base::Diagnostics& unread);
/// Trees that were not known when `inputs` were listed, as their parameter file could not be read.
base::Diagnostics unlistedNav2Trees(const sim2d::Scenario& scenario,
                                    const std::string& scenarioPath,
                                    const std::vector<std::string>& inputs);

/// The parameter files and trees that they read.
std::vector<std::string> nav2FilesOf(const sim2d::Scenario& scenario,
                                     const std::string& scenarioPath);

/// A parameter of a robot's file, as a form shows it. Values are YAML.
struct Nav2Parameter {
  std::string path;                  // below the robot's key `nav2`, the shortest that is its own
  std::string node, name;            // "controller_server", "FollowPath.temperature"
  std::string type, unit, meaning;   // "double"; a sentence, empty: Nav2 has none
  std::string fallback;              // of Nav2's code
  std::optional<std::string> filed;  // in the file
  std::optional<std::string> given;  // by the scenario, instead

  /// What counts.
  const std::string& value() const { return given ? *given : filed ? *filed : fallback; }
};
/// Those that have an effect, in the order of the file's servers; with errors of the file: what
/// could be read.
struct Nav2Sheet {
  std::string file;
  std::vector<Nav2Parameter> parameters;
  base::Diagnostics problems;
};
Nav2Sheet nav2SheetOf(const sim2d::Robot& robot, const std::string& scenarioPath);
/// The robot with a value instead of that of the file; none: with that of the file.
sim2d::Robot withNav2Value(sim2d::Robot robot, const Nav2Parameter& parameter,
                           std::optional<std::string> yaml);
/// What is wrong with a value that such a robot gives; empty: nothing.
std::string nav2ValueProblem(const sim2d::Robot& robot, const std::string& scenarioPath,
                             const Nav2Parameter& parameter, const std::string& yaml);

using Nav2Branch = std::optional<sim2d::nav2::Distro>;

/// Parameter files and single values (`name:=value`) by themselves, read as one in their order:
/// everything that is wrong, and what deserves a word. Without a branch, it is guessed from them.
base::Diagnostics checkNav2Files(const std::vector<std::string>& entries, Nav2Branch branch = {});
/// The same of one file.
base::Diagnostics checkNav2File(const std::string& path, Nav2Branch branch = {});
/// A navigator's tree alone. Without a branch, nodes of all branches are accepted.
base::Diagnostics checkNavigatorTree(const std::string& path, Nav2Branch branch = {});

}  // namespace app
