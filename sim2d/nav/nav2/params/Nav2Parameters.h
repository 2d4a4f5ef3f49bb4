#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
#include "sim2d/nav/nav2/docking/DockingParameters.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"
#include "sim2d/nav/nav2/params/BtNavigatorParameters.h"
#include "sim2d/nav/nav2/params/NodeReader.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"
#include "sim2d/nav/nav2/route/RouteParameters.h"
#include "sim2d/nav/nav2/servers/Behaviors.h"
#include "sim2d/nav/nav2/servers/CollisionMonitor.h"
#include "sim2d/nav/nav2/servers/VelocitySmoother.h"

/// A complete `nav2_params.yaml`: every server with its plugins.
namespace sim2d::nav2 {

/// behavior_server: the loaded behaviors and their keys.
struct BehaviorSettings {
  BehaviorParameters server;
  DriveParameters backUp, driveOnHeading;
  bool hasSpin = false, hasBackUp = false, hasDriveOnHeading = false, hasWait = false,
       hasAssistedTeleop = false;
};

struct Nav2Parameters {
  std::string file;                // the first file
  std::vector<std::string> files;  // all files in reading order
  Distro distro = Distro::Jazzy;
  bool isGuessed = false;                  // guessed from the file
  std::vector<std::string> distroReasons;  // evidence for the guess

  CostmapSettings localCostmap, globalCostmap;
  Nav2ParameterBlock controllerServer;  // with the plugins' keys, for makeControllerServer
  PlannerServerParameters plannerServer;
  std::vector<std::pair<std::string, GlobalPlannerParameters>> planners;  // by name
  SmootherServerParameters smootherServer;
  std::vector<std::pair<std::string, PathSmootherParameters>> smoothers;
  BehaviorSettings behaviors;
  VelocitySmootherParameters velocitySmoother;
  std::optional<CollisionMonitorParameters> collisionMonitor;  // none: absent from the file
  BtNavigatorParameters btNavigator;
  FrameNames frames;
  RouteSettings route;  // Nav2's defaults where the file has no route_server
  DockingServerParameters dockingServer;
  FollowingServerParameters followingServer;
  std::optional<WaypointFollowerParameters> waypointFollower;  // none: absent from the file
  std::string nodeNames;   // nodes of the file: "amcl, map_server"
  bool isPartial = false;  // without a controller, so the file alone cannot drive a robot
  /// Nav2's own tree replaces an unknown one: for plugins that the file lacks, the first are used.
  bool usesFirstPlugins = false;

  ParameterNotes notes;  // usage of every key of the file; `problems` is moved to Nav2ReadResult
};

struct Nav2ReadOptions {
  std::optional<Distro> distro;  // none: guessed
  std::string robot;             // preferred namespace
  bool onlyKeys = false;         // records only which keys are read; does not check values
};

/// Parameters and all problems, sorted by position in the file.
struct Nav2ReadResult {
  Nav2Parameters parameters;
  base::Diagnostics problems;
  bool ok() const { return !base::hasErrors(problems); }
};
Nav2ReadResult readNav2Parameters(const ParameterFile& file, const Nav2ReadOptions& options = {});

/// Adds the position in the file to a problem of a server: that of the key named in the problem's
/// values (the values called "where" are its path), else that of its plugin or node. Values set
/// from outside have no position.
base::Diagnostic withFilePosition(const Nav2Parameters& parameters, base::Diagnostic problem);

/// The folders in which a file named by the parameter `path` ("node.name") is searched: the folder
/// of the file that contains the parameter, then those of the other files.
std::vector<std::string> parameterFolders(const Nav2Parameters& parameters,
                                          const std::string& path);

/// Sets a parameter that `reading` contains: "FollowPath.temperature", preceded by its node where
/// several nodes have it. Errors: unknown parameter, ambiguous node, invalid YAML.
base::Diagnostics setNav2Value(ParameterFile& file, const Nav2ReadResult& reading,
                               const std::string& path, const std::string& yaml);

/// The name of a parameter: "controller_server" and "FollowPath.max_vel_x".
struct ParameterName {
  std::string node, name;
};
/// Finds the effective parameters called `path`, with or without the node's name, in all nodes.
/// Error: no such parameter.
base::Result<std::vector<ParameterName>> findNav2Parameters(const Nav2ReadResult& reading,
                                                            const std::string& path);
/// Overrides a value of the files with ROS 2's typing, in the named node or else in each node that
/// has the parameter according to `reading`. Errors: unknown parameter, invalid YAML.
base::Diagnostics overrideNav2Value(ParameterFile& file, const Nav2ReadResult& reading,
                                    const ParameterOverride& given);

/// The value given for a key of controller_server, or `defaultValue`.
template <class T>
T controllerValue(const Nav2Parameters& parameters, const std::string& key, T defaultValue) {
  const auto found = parameters.controllerServer.find(key);
  const T* const value =
      found == parameters.controllerServer.end() ? nullptr : std::get_if<T>(&found->second);
  return value != nullptr ? *value : defaultValue;
}
/// Position tolerance of the first goal checker [m].
double xyGoalTolerance(const Nav2Parameters& parameters);

}  // namespace sim2d::nav2
