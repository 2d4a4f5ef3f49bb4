#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt/robot/Nav2Files.h"
#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/world/Registries.h"

/// Nav2 files of a scenario's robots: parameter files, trees, and values that depend on them; the
/// registries of the program with planner `nav2`.

namespace app {

/// The shipped parameter files and trees.
bt::Nav2Folders shippedNav2Folders();

/// Values of the scenario for parameters (`nav2.FollowPath.temperature`) that match no parameter.
/// Problems of the files are reported when the world is created.
base::Diagnostics wrongNav2Values(const sim2d::Scenario& scenario, const std::string& scenarioPath);
/// The scenario for a world: robots of `nav2` without a `goal_radius` get the tolerance of the goal
/// checker in their file. `unread`: why it is unknown; nothing else reports this if the file is
/// readable when the world is created.
std::shared_ptr<const sim2d::Scenario> withNav2GoalRadius(
    const std::shared_ptr<const sim2d::Scenario>& scenario, const std::string& scenarioPath,
    base::Diagnostics& unread);
/// Trees that were unknown when `inputs` were listed, because their parameter file was unreadable.
base::Diagnostics unlistedNav2Trees(const sim2d::Scenario& scenario,
                                    const std::string& scenarioPath,
                                    const std::vector<std::string>& inputs);

/// The parameter files and trees that the robots read.
std::vector<std::string> nav2FilesOf(const sim2d::Scenario& scenario,
                                     const std::string& scenarioPath);

/// A parameter of a robot's file, for forms. Values are YAML.
struct Nav2Parameter {
  std::string path;                 // below the robot's key `nav2`, the shortest unambiguous path
  std::string node, name;           // "controller_server", "FollowPath.temperature"
  std::string type, unit, meaning;  // "double"; a sentence, empty: Nav2 has none
  std::string fallback;             // the default in Nav2's code
  std::optional<std::string> fileValue;  // in the file
  std::optional<std::string> given;      // by the scenario, overriding the file

  /// The value in effect.
  const std::string& value() const { return given ? *given : fileValue ? *fileValue : fallback; }
};
/// The parameters in effect, in the order of the file's servers; if the file has errors, those that
/// could be read.
struct Nav2ParameterList {
  std::string file;
  std::vector<Nav2Parameter> parameters;
  base::Diagnostics problems;
};
Nav2ParameterList nav2ParameterListOf(const sim2d::Robot& robot, const std::string& scenarioPath);
/// The robot with this value overriding the file; nullopt removes the override.
sim2d::Robot withNav2Value(sim2d::Robot robot, const Nav2Parameter& parameter,
                           std::optional<std::string> yaml);
/// The problem of a value for this robot; empty if it is valid.
std::string nav2ValueProblem(const sim2d::Robot& robot, const std::string& scenarioPath,
                             const Nav2Parameter& parameter, const std::string& yaml);

using Nav2Branch = std::optional<sim2d::nav2::Distro>;

/// Checks parameter files and single values (`name:=value`), read as one in their order: all errors
/// and warnings. Without a branch, it is guessed from them.
base::Diagnostics checkNav2Files(const std::vector<std::string>& entries, Nav2Branch branch = {});
/// Checks a navigator's tree without parameters. Without a branch, nodes of all branches are
/// accepted.
base::Diagnostics checkNavigatorTree(const std::string& path, Nav2Branch branch = {});

/// The footprint of a robot as in its Nav2 parameter files.

/// Returns the robot with the shape of local_costmap in its parameter files, without padding:
/// `footprint` as its footprint, otherwise `robot_radius` as its radius (see Robot; m, robot
/// frame). It replaces the shape of the scenario. Error: the files cannot be read, or contain
/// neither.
base::Result<sim2d::Robot> withNav2Body(sim2d::Robot robot, const std::string& scenarioPath);

/// The scenario for a run: robots that planner nav2 drives and whose `nav2_body` is true get that
/// shape. If the files give none, the robot keeps its own, with a warning in `problems`; unreadable
/// files are not reported here.
std::shared_ptr<const sim2d::Scenario> withNav2Bodies(
    const std::shared_ptr<const sim2d::Scenario>& scenario, const std::string& scenarioPath,
    base::Diagnostics& problems);

/// All registries of the program, with the planner `nav2`, which is in a layer above the world.
sim2d::Registries builtinRegistries();
/// The names of planners in the order of lists: those of this program, nav2, then those that run
/// code or policies of the user, alphabetically in each group.
std::vector<std::string> listedPlanners(const sim2d::Registries& registries);
std::shared_ptr<const sim2d::Registries> sharedRegistries();

}  // namespace app
