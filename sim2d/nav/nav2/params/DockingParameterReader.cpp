#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "sim2d/base/Ranges.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/nav/nav2/params/NodeReader.h"
#include "sim2d/nav/nav2/params/ReferencedFiles.h"
#include "sim2d/nav/nav2/params/ServerParameterReader.h"

namespace sim2d::nav2 {
namespace {

// ---- docking_server

constexpr const char* kChargingDock = "opennav_docking::SimpleChargingDock";
constexpr const char* kNonChargingDock = "opennav_docking::SimpleNonChargingDock";

/// A class that is not re-implemented counts as a charging dock unless its name contains
/// "NonCharging".
bool isCharger(const std::string& type) {
  return normalizedPluginClass(type).find("NonCharging") == std::string::npos;
}

void readDockPlugin(NodeReader& node, const std::string& name, DockingServerParameters& to) {
  const std::string type = pluginClass(node, name, "");
  if (type.empty()) {
    return;
  }
  DockPluginParameters plugin;
  plugin.isCharger = isCharger(type);
  const std::string known = plugin.isCharger ? kChargingDock : kNonChargingDock;
  if (normalizedPluginClass(type) != known) {
    reportSubstitute(node, name, type, known, "docks of other packages are not re-implemented");
  }
  const std::string prefix = name + ".";
  plugin = node.read(prefix, plugin.isCharger ? dockPluginKeys() : nonChargingDockKeys(),
                     ignoredDockPluginKeys(), plugin);
  plugin.name = name;
  if (normalizedPluginClass(type) != known) {
    node.markIgnored(prefix, "a key of " + type);
  }
  reportProblems(node, problemsOf(plugin));
  to.plugins.push_back(std::move(plugin));
}

/// Keys of one dock in the parameters of docking_server.
struct DockKeys {
  std::string type, frame = "map", id;
  std::vector<double> pose;
};
const std::vector<Nav2Key<DockKeys>>& dockInstanceKeys() {
  static const std::vector<Nav2Key<DockKeys>> kKeys = {
      {"type", &DockKeys::type, "", "Class of the dock, by its name in dock_plugins.", kSinceJazzy},
      {"frame", &DockKeys::frame, "", "Frame of the pose; all frames are identical.", kSinceJazzy},
      {"pose", &DockKeys::pose, "", "x, y [m] and heading [rad] of a docked robot.", kSinceJazzy},
      {"id", &DockKeys::id, "", "Identifier for detectors.", kSinceJazzy}};
  return kKeys;
}

bool isPose(const std::vector<double>& pose) {
  return pose.size() == 3 && std::all_of(pose.begin(), pose.end(), [](double value) {
           return std::fabs(value) <= base::kMaxCoordinate;
         });
}

DockInstance instanceOf(const std::string& name, const DockKeys& keys) {
  return {
      name, keys.type, keys.frame, {{keys.pose[0], keys.pose[1]}, base::wrapToPi(keys.pose[2])}};
}

base::Diagnostic badPose(const std::string& dock) {
  return base::error("nav2.bad-parameter", {dock + ".pose", "three numbers [x, y, heading]"});
}

void readDocks(NodeReader& node, DockingServerParameters& to) {
  for (const std::string& name : uniquePluginNames(node, "docks", to.docks)) {
    const DockKeys keys = node.read(name + ".", dockInstanceKeys(), {}, DockKeys());
    if (!includesDistro(kSinceJazzy, node.distro())) {
      continue;
    }
    if (isPose(keys.pose)) {
      to.instances.push_back(instanceOf(name, keys));
    } else {
      node.report(name + ".pose", badPose(name));
    }
  }
}

/// Reads the file that `dock_database` names: `docks: {NAME: {type, frame, pose, id}}`.
void readDatabaseFile(const std::string& path, base::Diagnostics& problems,
                      DockingServerParameters& to) {
  const base::Result<std::string> text = base::readTextFile(path);
  base::append(problems, text.diagnostics());
  if (!text) {
    return;
  }
  const base::YamlNode tree = base::parseYaml(*text, path, problems);
  const base::YamlNode* const docks = tree.find("docks");
  if (docks == nullptr || !docks->isMap()) {
    problems.push_back(
        base::error("nav2.bad-parameter", {"docks", "a map of docks"}, path, tree.line));
    return;
  }
  for (const base::YamlNode& dock : docks->items) {
    DockKeys keys;
    for (const auto& [key, value] : {std::pair("type", &keys.type), {"frame", &keys.frame}}) {
      if (const base::YamlNode* const given = dock.find(key)) {
        *value = given->text;
      }
    }
    if (const base::YamlNode* const pose = dock.find("pose")) {
      for (const base::YamlNode& value : pose->items) {
        keys.pose.push_back(base::parseDouble(value.text).value_or(HUGE_VAL));
      }
    }
    if (isPose(keys.pose)) {
      to.instances.push_back(instanceOf(dock.key, keys));
    } else {
      base::Diagnostic problem = badPose(dock.key);
      problem.file = path;
      problem.line = dock.line;
      problem.column = dock.column;
      problems.push_back(std::move(problem));
    }
  }
}

/// A path on another computer is searched beside the parameter file `file`.
void readDockDatabase(NodeReader& node, const std::string& file, base::Diagnostics& problems,
                      DockingServerParameters& to) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  const ReferencedFile found = findReferencedFile(to.dockDatabase, {folder});
  if (found.file.empty()) {
    node.report("dock_database",
                referencedFileMissing("dock_database", to.dockDatabase, found, "no dock"));
    return;
  }
  to.dockDatabase = found.file;
  readDatabaseFile(found.file, problems, to);
}

DockingServerParameters readDockingServer(NodeReader node, const std::string& file, bool onlyKeys,
                                          base::Diagnostics& problems) {
  DockingServerParameters to =
      node.read({}, dockingServerKeys(), ignoredDockingServerKeys(), DockingServerParameters());
  to.hasDockBackwards = node.has("dock_backwards");
  reportProblems(node, problemsOf(to));
  for (const std::string& name : uniquePluginNames(node, "dock_plugins", to.dockPlugins)) {
    readDockPlugin(node, name, to);
  }
  if (to.dockDatabase.empty()) {
    readDocks(node, to);
  } else if (!onlyKeys) {
    readDockDatabase(node, file, problems, to);
  }
  node.finish();
  return to;
}

// ---- following_server, waypoint_follower

FollowingServerParameters readFollowingServer(NodeReader node) {
  FollowingServerParameters to = node.read({}, followingServerKeys(), ignoredFollowingServerKeys(),
                                           FollowingServerParameters());
  reportProblems(node, problemsOf(to));
  node.finish();
  return to;
}

WaypointTaskParameters readTask(NodeReader& node, const std::string& name) {
  WaypointTaskParameters task;
  const std::string type = pluginClass(
      node, name, name == "wait_at_waypoint" ? "nav2_waypoint_follower::WaitAtWaypoint" : "");
  static constexpr std::array<const char*, 3> kClasses = {
      "nav2_waypoint_follower::WaitAtWaypoint", "nav2_waypoint_follower::PhotoAtWaypoint",
      "nav2_waypoint_follower::InputAtWaypoint"};
  const auto* const found =
      std::find(kClasses.begin(), kClasses.end(), normalizedPluginClass(type));
  if (found == kClasses.end()) {
    if (!type.empty()) {
      reportOmittedPlugin(node, name, type, "only Nav2's own tasks are re-implemented");
    }
    node.markIgnored(name + ".", "its class is not implemented");
    return task;
  }
  task.kind = static_cast<WaypointTask>(found - kClasses.begin() + 1);
  task = node.read(name + ".", waypointTaskKeys(task.kind), ignoredWaypointTaskKeys(), task);
  return task;
}

void readWaypointFollower(NodeReader node, WaypointFollowerParameters& to) {
  to = node.read({}, waypointFollowerKeys(), ignoredWaypointFollowerKeys(), to);
  if (!to.taskPlugin.empty()) {
    to.task = readTask(node, to.taskPlugin);
  }
  node.finish();
}

}  // namespace

void readDocking(Nav2Parameters& to, const std::function<NodeReader(const std::string&)>& reader,
                 const ParameterFile& file) {
  if (file.hasNode("docking_server")) {
    to.dockingServer = readDockingServer(reader("docking_server"), file.file(), to.notes.onlyKeys,
                                         to.notes.problems);
  }
  if (file.hasNode("following_server")) {
    to.followingServer = readFollowingServer(reader("following_server"));
  }
  if (file.hasNode("waypoint_follower")) {
    readWaypointFollower(reader("waypoint_follower"), to.waypointFollower.emplace());
  }
}

}  // namespace sim2d::nav2
