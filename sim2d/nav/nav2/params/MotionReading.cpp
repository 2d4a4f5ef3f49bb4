#include "sim2d/nav/nav2/params/MotionReading.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/PluginBlocks.h"

namespace sim2d::nav2 {
namespace {

constexpr std::array<const char*, 5> kBehaviors = {"Spin", "BackUp", "DriveOnHeading", "Wait",
                                                   "AssistedTeleop"};

bool hasNode(const ParameterFile& file, const std::string& name) {
  return std::any_of(file.nodes().begin(), file.nodes().end(),
                     [&](const NodeParameters& node) { return node.node == name; });
}

/// "nav2_behaviors::Spin", or "nav2_recoveries/Spin" as before Humble; its place in kBehaviors.
std::size_t behaviorOf(const std::string& plugin) {
  const std::string name = pluginName(plugin);
  for (std::size_t i = 0; i < kBehaviors.size(); ++i) {
    for (const char* const package : {"nav2_behaviors::", "nav2_recoveries::"}) {
      if (name == std::string(package) + kBehaviors[i]) {
        return i;
      }
    }
  }
  return kBehaviors.size();
}

/// Nav2 has these when no behaviours are named.
std::string usualBehavior(const NodeReader& node, const std::string& name) {
  static constexpr std::array<std::pair<const char*, const char*>, 4> kUsual = {
      {{"spin", "nav2_behaviors::Spin"},
       {"backup", "nav2_behaviors::BackUp"},
       {"drive_on_heading", "nav2_behaviors::DriveOnHeading"},
       {"wait", "nav2_behaviors::Wait"}}};
  for (const auto& [behavior, plugin] : kUsual) {
    if (name == behavior && !node.has("behavior_plugins")) {
      return plugin;
    }
  }
  return {};
}

void readBehavior(NodeReader& node, const std::string& name, BehaviorSettings& to) {
  const std::string plugin = pluginClass(node, name, usualBehavior(node, name));
  if (plugin.empty()) {
    return;
  }
  const DriveParameters drive = driveDefaults(node.distro());
  switch (behaviorOf(plugin)) {
    case 0:
      to.hasSpin = true;
      break;
    case 1:
      to.hasBackUp = true;
      to.backUp = node.read(name + ".", driveKeys(), {}, drive);
      tellAt(node, problemsOf(to.backUp, name));
      break;
    case 2:
      to.hasDriveOnHeading = true;
      to.driveOnHeading = node.read(name + ".", driveKeys(), {}, drive);
      tellAt(node, problemsOf(to.driveOnHeading, name));
      break;
    case 3:
      to.hasWait = true;
      break;
    case 4:
      to.hasAssistedTeleop = true;
      break;
    default: {
      std::vector<std::string> known;
      known.reserve(std::size(kBehaviors));
      for (const char* const behavior : kBehaviors) {
        known.push_back(std::string("nav2_behaviors::") + behavior);
      }
      if (isMisspelt(plugin, known)) {
        tellUnknownPlugin(node, name, plugin, known);
      } else {
        tellLeftOut(node, name, plugin, "its package is not re-implemented");
      }
      node.know(name + ".", "its class is not here");
    }
  }
}

void readBehaviors(NodeReader node, BehaviorSettings& to) {
  to.server = node.read({}, behaviorKeys(), idleBehaviorKeys(), BehaviorParameters());
  tellAt(node, problemsOf(to.server));
  to.backUp = to.driveOnHeading = driveDefaults(node.distro());
  for (const std::string& name : pluginNames(node, "behavior_plugins", to.server.behaviorPlugins)) {
    readBehavior(node, name, to);
  }
  node.finish();
}

VelocitySmootherParameters readSmoother(NodeReader node) {
  VelocitySmootherParameters smoother = node.read(
      {}, velocitySmootherKeys(), idleVelocitySmootherKeys(), VelocitySmootherParameters());
  tellAt(node, problemsOf(smoother));
  node.finish();
  return smoother;
}

MonitorPolygon readShape(NodeReader& node, const std::string& name) {
  MonitorPolygon shape =
      node.read(name + ".", monitorPolygonKeys(), idleCollisionMonitorKeys(), MonitorPolygon());
  shape.name = name;
  for (const std::string& sub : shape.velocityPolygons) {
    const std::string prefix = base::join({name, sub, ""}, ".");
    VelocitySubPolygon part = node.read(prefix, velocitySubPolygonKeys(), {}, VelocitySubPolygon());
    part.name = sub;
    shape.subPolygons.push_back(std::move(part));
  }
  return shape;
}

CollisionMonitorParameters readMonitor(NodeReader node) {
  CollisionMonitorParameters monitor = node.read(
      {}, collisionMonitorKeys(), idleCollisionMonitorKeys(), CollisionMonitorParameters());
  for (const std::string& name : pluginNames(node, "polygons", monitor.polygons)) {
    monitor.shapes.push_back(readShape(node, name));
  }
  for (const std::string& name :
       pluginNames(node, "observation_sources", monitor.observationSources)) {
    MonitorSource source;
    source.sourceTimeout = monitor.sourceTimeout;
    source = node.read(name + ".", monitorSourceKeys(), idleCollisionMonitorKeys(), source);
    source.name = name;
    monitor.sources.push_back(std::move(source));
  }
  tellAt(node, problemsOf(monitor));
  node.finish();
  return monitor;
}

}  // namespace

void readMotions(Nav2Parameters& to, const std::function<NodeReader(const std::string&)>& reader,
                 const ParameterFile& file) {
  const bool isOld = hasNode(file, "recoveries_server") && !hasNode(file, "behavior_server");
  readBehaviors(reader(isOld ? "recoveries_server" : "behavior_server"), to.behaviors);
  to.velocitySmoother = readSmoother(reader("velocity_smoother"));
  if (hasNode(file, "collision_monitor")) {
    to.collisionMonitor = readMonitor(reader("collision_monitor"));
  }
}

}  // namespace sim2d::nav2
