#include "sim2d/nav/nav2/params/DockingReading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "sim2d/base/Ranges.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/nav/nav2/params/NamedFiles.h"
#include "sim2d/nav/nav2/params/PluginBlocks.h"

namespace sim2d::nav2 {
namespace {

bool fileHas(const ParameterFile& file, const std::string& name) {
  return std::any_of(file.nodes().begin(), file.nodes().end(),
                     [&](const NodeParameters& node) { return node.node == name; });
}

// ---- docking_server
// ------------------------------------------------------------------------------

constexpr const char* kChargingDock = "opennav_docking::SimpleChargingDock";
constexpr const char* kParkingDock = "opennav_docking::SimpleNonChargingDock";

/// A class that is not re-implemented charges if its name does not say otherwise.
bool isCharger(const std::string& type) {
  return pluginName(type).find("NonCharging") == std::string::npos;
}

void readDockPlugin(NodeReader& node, const std::string& name, DockingServerParameters& to) {
  const std::string type = pluginClass(node, name, "");
  if (type.empty()) {
    return;
  }
  DockPluginParameters plugin;
  plugin.isCharger = isCharger(type);
  const std::string known = plugin.isCharger ? kChargingDock : kParkingDock;
  if (pluginName(type) != known) {
    tellSubstitute(node, name, type, known, "docks of other packages are not re-implemented");
  }
  const std::string prefix = name + ".";
  plugin = node.read(prefix, plugin.isCharger ? dockPluginKeys() : parkingDockKeys(),
                     idleDockPluginKeys(), plugin);
  plugin.name = name;
  if (pluginName(type) != known) {
    node.know(prefix, "a key of " + type);
  }
  tellAt(node, problemsOf(plugin));
  to.plugins.push_back(std::move(plugin));
}

/// Keys of one dock in the file of the server.
struct DockKeys {
  std::string type, frame = "map", id;
  std::vector<double> pose;
};
const std::vector<Nav2Key<DockKeys>>& dockInstanceKeys() {
  static const std::vector<Nav2Key<DockKeys>> kKeys = {
      {"type", &DockKeys::type, "", "Class of the dock, by its name in dock_plugins.", kSinceJazzy},
      {"frame", &DockKeys::frame, "", "Frame of the pose; frames coincide here.", kSinceJazzy},
      {"pose", &DockKeys::pose, "", "x, y [m] and heading [rad] of a docked robot.", kSinceJazzy},
      {"id", &DockKeys::id, "", "Identifier for detectors.", kSinceJazzy}};
  return kKeys;
}

bool isPose(const std::vector<double>& pose) {
  return pose.size() == 3 && std::all_of(pose.begin(), pose.end(), [](double value) {
           return std::fabs(value) <= base::kFarthest;
         });
}

DockInstance instanceOf(const std::string& name, const DockKeys& keys) {
  return {
      name, keys.type, keys.frame, {{keys.pose[0], keys.pose[1]}, base::wrapToPi(keys.pose[2])}};
}

void readDocks(NodeReader& node, DockingServerParameters& to) {
  for (const std::string& name : pluginNames(node, "docks", to.docks)) {
    const DockKeys keys = node.read(name + ".", dockInstanceKeys(), {}, DockKeys());
    if (!isIn(kSinceJazzy, node.distro())) {
      continue;
    }
    if (isPose(keys.pose)) {
      to.instances.push_back(instanceOf(name, keys));
    } else {
      node.tell(name + ".pose", base::error("nav2.bad-parameter",
                                            {name + ".pose", "three numbers [x, y, heading]"}));
    }
  }
}

/// The file that `dock_database` names: `docks: {NAME: {type, frame, pose, id}}`.
class DockDatabase {
 public:
  DockDatabase(std::string path, base::Diagnostics& problems)
      : path_(std::move(path)), problems_(problems) {}

  void read(DockingServerParameters& to) {
    const base::Result<std::string> text = base::readTextFile(path_);
    base::append(problems_, text.diagnostics());
    if (!text) {
      return;
    }
    const base::YamlNode tree = base::parseYaml(*text, path_, problems_);
    const base::YamlNode* const docks = tree.find("docks");
    if (docks == nullptr || !docks->isMap()) {
      problems_.push_back(
          base::error("nav2.bad-parameter", {"docks", "a map of docks"}, path_, tree.line));
      return;
    }
    for (const base::YamlNode& dock : docks->items) {
      readDock(dock, to);
    }
  }

 private:
  void readDock(const base::YamlNode& dock, DockingServerParameters& to) {
    DockKeys keys;
    if (const base::YamlNode* const type = dock.find("type")) {
      keys.type = type->text;
    }
    if (const base::YamlNode* const frame = dock.find("frame")) {
      keys.frame = frame->text;
    }
    if (const base::YamlNode* const pose = dock.find("pose")) {
      for (const base::YamlNode& value : pose->items) {
        keys.pose.push_back(base::parseDouble(value.text).value_or(HUGE_VAL));
      }
    }
    if (isPose(keys.pose)) {
      to.instances.push_back(instanceOf(dock.key, keys));
    } else {
      problems_.push_back(base::error("nav2.bad-parameter",
                                      {dock.key + ".pose", "three numbers [x, y, heading]"}, path_,
                                      dock.line, dock.column));
    }
  }

  std::string path_;
  base::Diagnostics& problems_;
};

/// A path of another computer is looked for beside the parameter file `file`.
void readDockDatabase(NodeReader& node, const std::string& file, base::Diagnostics& problems,
                      DockingServerParameters& to) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  const NamedFile found = findNamedFile(to.dockDatabase, {folder});
  if (found.file.empty()) {
    node.tell("dock_database",
              namedFileMissing("dock_database", to.dockDatabase, found, "no dock"));
    return;
  }
  to.dockDatabase = found.file;
  DockDatabase(found.file, problems).read(to);
}

DockingServerParameters readDockingServer(NodeReader node, const std::string& file, bool onlyKeys,
                                          base::Diagnostics& problems) {
  DockingServerParameters to =
      node.read({}, dockingServerKeys(), idleDockingServerKeys(), DockingServerParameters());
  to.hasDockBackwards = node.has("dock_backwards");
  tellAt(node, problemsOf(to));
  for (const std::string& name : pluginNames(node, "dock_plugins", to.dockPlugins)) {
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
// ---------------------------------------------------------

FollowingServerParameters readFollowingServer(NodeReader node) {
  FollowingServerParameters to =
      node.read({}, followingServerKeys(), idleFollowingServerKeys(), FollowingServerParameters());
  tellAt(node, problemsOf(to));
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
  const auto* const found = std::find(kClasses.begin(), kClasses.end(), pluginName(type));
  if (found == kClasses.end()) {
    if (!type.empty()) {
      tellLeftOut(node, name, type, "only Nav2's own tasks are re-implemented");
    }
    node.know(name + ".", "its class is not here");
    return task;
  }
  task.kind = static_cast<WaypointTask>(found - kClasses.begin() + 1);
  task = node.read(name + ".", waypointTaskKeys(task.kind), idleWaypointTaskKeys(), task);
  return task;
}

void readWaypointFollower(NodeReader node, WaypointFollowerParameters& to) {
  to = node.read({}, waypointFollowerKeys(), idleWaypointFollowerKeys(), to);
  if (!to.taskPlugin.empty()) {
    to.task = readTask(node, to.taskPlugin);
  }
  node.finish();
}

}  // namespace

void readDocking(Nav2Parameters& to, const std::function<NodeReader(const std::string&)>& reader,
                 const ParameterFile& file) {
  if (fileHas(file, "docking_server")) {
    to.dockingServer = readDockingServer(reader("docking_server"), file.file(), to.notes.onlyKeys,
                                         to.notes.problems);
  }
  if (fileHas(file, "following_server")) {
    to.followingServer = readFollowingServer(reader("following_server"));
  }
  if (fileHas(file, "waypoint_follower")) {
    readWaypointFollower(reader("waypoint_follower"), to.waypointFollower.emplace());
  }
}

}  // namespace sim2d::nav2
