#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Nav2Block.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
#include "sim2d/nav/nav2/docking/DockingParameters.h"
#include "sim2d/nav/nav2/global/GlobalPlanners.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"
#include "sim2d/nav/nav2/params/BtNavigator.h"
#include "sim2d/nav/nav2/params/FrameNames.h"
#include "sim2d/nav/nav2/params/NodeReader.h"
#include "sim2d/nav/nav2/route/RouteParameters.h"
#include "sim2d/nav/nav2/servers/Behaviors.h"
#include "sim2d/nav/nav2/servers/CollisionMonitor.h"
#include "sim2d/nav/nav2/servers/VelocitySmoother.h"
#include "sim2d/nav/nav2/servers/WaypointTasks.h"

/// A `nav2_params.yaml` as a whole: every server with its plugins.
namespace sim2d::nav2 {

/// behavior_server: which of the behaviours are loaded, and their keys.
struct BehaviorSettings {
  BehaviorParameters server;
  DriveParameters backUp, driveOnHeading;
  bool hasSpin = false, hasBackUp = false, hasDriveOnHeading = false, hasWait = false,
       hasAssistedTeleop = false;
};

struct Nav2Parameters {
  std::string file;                // the first of them
  std::vector<std::string> files;  // all, in the order in which they are read
  Distro distro = Distro::Jazzy;
  bool isGuessed = false;                  // from the file
  std::vector<std::string> distroReasons;  // of the guess

  CostmapSettings localCostmap, globalCostmap;
  Nav2Block controllerServer;  // with its plugins below their names, for makeControllerServer
  PlannerServerParameters plannerServer;
  std::vector<std::pair<std::string, GlobalPlannerParameters>> planners;  // by name
  SmootherServerParameters smootherServer;
  std::vector<std::pair<std::string, PathSmootherParameters>> smoothers;
  BehaviorSettings behaviors;
  VelocitySmootherParameters velocitySmoother;
  std::optional<CollisionMonitorParameters> collisionMonitor;  // none: not in the file
  BtNavigatorParameters btNavigator;
  FrameNames frames;
  RouteSettings route;  // Nav2's defaults where the file has no route_server
  DockingServerParameters dockingServer;
  FollowingServerParameters followingServer;
  std::optional<WaypointFollowerParameters> waypointFollower;  // none: not in the file
  std::string held;        // nodes of the file: "amcl, map_server"
  bool isPartial = false;  // has no controller, so it cannot drive a robot by itself

  ReadingNotes notes;  // of every key of the file; its problems are those of the result
};

struct Nav2ReadOptions {
  std::optional<Distro> distro;  // none: guessed
  std::string robot;             // its namespace counts before others
  bool onlyKeys = false;         // which keys are read; values are not checked
};

/// Everything at once, in the order of the file.
struct Nav2Reading {
  Nav2Parameters parameters;
  base::Diagnostics problems;
  bool ok() const { return !base::hasErrors(problems); }
};
Nav2Reading readNav2Parameters(const ParameterFile& file, const Nav2ReadOptions& options = {});

/// The problem of a server, with the place of the key that it names in its values (those called
/// "where" are its path), else of its plugin or node. Values that were set have no place.
base::Diagnostic placedInFile(const Nav2Parameters& parameters, base::Diagnostic problem);

/// The folders in which files are searched that the parameter of this path names ("node.name"):
/// that of the file which has it, then those of the others.
std::vector<std::string> foldersOfParameter(const Nav2Parameters& parameters,
                                            const std::string& path);

/// Puts a value at a parameter that `reading` knows: "FollowPath.temperature", with its node in
/// front where several have it. Errors: no such parameter, several nodes, no YAML.
base::Diagnostics setNav2Value(ParameterFile& file, const Nav2Reading& reading,
                               const std::string& path, const std::string& yaml);

/// A parameter of a node, "controller_server" and "FollowPath.max_vel_x".
struct ParameterName {
  std::string node, name;
};
/// Those that have an effect by the name `path`, with or without their node in front; of several
/// nodes all. Error: there is none.
base::Result<std::vector<ParameterName>> nav2ParametersNamed(const Nav2Reading& reading,
                                                             const std::string& path);
/// Puts a value over those of the files, of ROS 2's types: at the node that it names, else at each
/// node that `reading` knows to have the parameter. Errors: no such parameter, no YAML.
base::Diagnostics overrideNav2Value(ParameterFile& file, const Nav2Reading& reading,
                                    const ParameterOverride& given);

/// What was given for the plugin of the controller server, or what Nav2 has without it.
template <class T>
T controllerValue(const Nav2Parameters& parameters, const std::string& key, T otherwise) {
  const auto found = parameters.controllerServer.find(key);
  const T* const value =
      found == parameters.controllerServer.end() ? nullptr : std::get_if<T>(&found->second);
  return value != nullptr ? *value : otherwise;
}
/// Of the goal checker that comes first [m].
double xyGoalTolerance(const Nav2Parameters& parameters);

}  // namespace sim2d::nav2
