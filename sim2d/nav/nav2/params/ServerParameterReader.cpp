#include "sim2d/nav/nav2/params/ServerParameterReader.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "sim2d/nav/nav2/params/NodeReader.h"
#include "sim2d/nav/nav2/params/RosValue.h"

namespace sim2d::nav2 {
namespace {

constexpr std::array<const char*, 5> kBehaviors = {"Spin", "BackUp", "DriveOnHeading", "Wait",
                                                   "AssistedTeleop"};

/// The index in kBehaviors of "nav2_behaviors::Spin", or of "nav2_recoveries/Spin" as before
/// Humble; the size of kBehaviors for other classes.
std::size_t behaviorOf(const std::string& plugin) {
  const std::string name = normalizedPluginClass(plugin);
  for (std::size_t i = 0; i < kBehaviors.size(); ++i) {
    for (const char* const package : {"nav2_behaviors::", "nav2_recoveries::"}) {
      if (name == std::string(package) + kBehaviors[i]) {
        return i;
      }
    }
  }
  return kBehaviors.size();
}

/// Nav2 loads these behaviors when `behavior_plugins` is absent.
constexpr std::array<DefaultPlugin, 4> kDefaultBehaviors = {
    {{"spin", "nav2_behaviors::Spin"},
     {"backup", "nav2_behaviors::BackUp"},
     {"drive_on_heading", "nav2_behaviors::DriveOnHeading"},
     {"wait", "nav2_behaviors::Wait"}}};

void readBehavior(NodeReader& node, const std::string& name, BehaviorSettings& to) {
  const std::string plugin =
      pluginClass(node, name, defaultClass(node, "behavior_plugins", name, kDefaultBehaviors));
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
      reportProblems(node, problemsOf(to.backUp, name));
      break;
    case 2:
      to.hasDriveOnHeading = true;
      to.driveOnHeading = node.read(name + ".", driveKeys(), {}, drive);
      reportProblems(node, problemsOf(to.driveOnHeading, name));
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
        reportUnknownPlugin(node, name, plugin, known);
      } else {
        reportOmittedPlugin(node, name, plugin, "its package is not re-implemented");
      }
      node.markIgnored(name + ".", "its class is not implemented");
    }
  }
}

void readBehaviors(NodeReader node, BehaviorSettings& to) {
  to.server = node.read({}, behaviorKeys(), ignoredBehaviorKeys(), BehaviorParameters());
  reportProblems(node, problemsOf(to.server));
  to.backUp = to.driveOnHeading = driveDefaults(node.distro());
  for (const std::string& name :
       uniquePluginNames(node, "behavior_plugins", to.server.behaviorPlugins)) {
    readBehavior(node, name, to);
  }
  node.finish();
}

VelocitySmootherParameters readVelocitySmoother(NodeReader node) {
  VelocitySmootherParameters smoother = node.read(
      {}, velocitySmootherKeys(), ignoredVelocitySmootherKeys(), VelocitySmootherParameters());
  reportProblems(node, problemsOf(smoother));
  node.finish();
  return smoother;
}

/// Until Iron the corners are a list x1, y1, x2 …, since Jazzy a string "[[x, y], …]".
void convertOldPoints(NodeReader& node, const std::string& name) {
  const std::string key = name + ".points";
  const GivenParameter* const given = node.parameters().find(key);
  if (node.distro() == Distro::Humble || given == nullptr || !given->value->isList()) {
    return;
  }
  const auto value = toRosValue(*given->value, Nav2Value(std::vector<double>()));
  const auto* const numbers = value ? std::get_if<std::vector<double>>(&*value) : nullptr;
  if (numbers == nullptr || numbers->empty() || numbers->size() % 2 != 0) {
    return;
  }
  std::vector<std::string> corners;
  corners.reserve(numbers->size() / 2);
  for (std::size_t i = 0; i < numbers->size(); i += 2) {
    corners.push_back(valueText(Nav2Value(std::vector<double>{(*numbers)[i], (*numbers)[i + 1]})));
  }
  base::YamlNode points = base::stringNode("[" + base::join(corners, ", ") + "]");
  points.line = given->value->line;
  points.column = given->value->column;
  node.report(key, base::warning("nav2.points-of-iron", {node.node() + "." + key,
                                                         distroTitle(node.distro()), points.text}));
  std::string file = given->file;
  node.supply(key, std::move(points), std::move(file));
}

MonitorPolygon readShape(NodeReader& node, const std::string& name) {
  convertOldPoints(node, name);
  MonitorPolygon shape =
      node.read(name + ".", monitorPolygonKeys(), ignoredCollisionMonitorKeys(), MonitorPolygon());
  shape.name = name;
  for (const std::string& sub : shape.velocityPolygons) {
    const std::string prefix = base::join({name, sub, ""}, ".");
    VelocitySubPolygon part = node.read(prefix, velocitySubPolygonKeys(), {}, VelocitySubPolygon());
    part.name = sub;
    shape.subPolygons.push_back(std::move(part));
  }
  return shape;
}

/// The kind of a frame; nullopt: no such frame.
std::optional<ZoneFrame> zoneFrameOf(const std::string& frameId, const FrameNames& frames) {
  const std::string name = !frameId.empty() && frameId.front() == '/' ? frameId.substr(1) : frameId;
  if (name.empty() || std::binary_search(frames.onRobot.begin(), frames.onRobot.end(), name)) {
    return ZoneFrame::Robot;
  }
  return name == frames.odom  ? std::optional(ZoneFrame::Odom)
         : name == frames.map ? std::optional(ZoneFrame::Map)
                              : std::nullopt;
}

/// A zone in an unknown frame is left out.
void readZone(NodeReader& node, const std::string& name, const FrameNames& frames,
              std::vector<ExclusionZone>& to) {
  ExclusionZone zone =
      node.read(name + ".", exclusionZoneKeys(), ignoredExclusionZoneKeys(), ExclusionZone());
  zone.name = name;
  const std::optional<ZoneFrame> frame = zoneFrameOf(zone.frameId, frames);
  if (frame) {
    zone.frame = *frame;
    to.push_back(std::move(zone));
  } else if (zone.enabled) {
    node.report(name + ".frame_id",
                base::warning("nav2.left-out", {node.node() + "." + name, zone.frameId,
                                                "a frame that is neither on the robot nor odom "
                                                "or map"}));
  }
}

CollisionMonitorParameters readCollisionMonitor(NodeReader node, const FrameNames& frames) {
  CollisionMonitorParameters monitor = node.read(
      {}, collisionMonitorKeys(), ignoredCollisionMonitorKeys(), CollisionMonitorParameters());
  for (const std::string& name : uniquePluginNames(node, "polygons", monitor.polygons)) {
    monitor.shapes.push_back(readShape(node, name));
  }
  for (const std::string& name :
       uniquePluginNames(node, "observation_sources", monitor.observationSources)) {
    MonitorSource source;
    source.sourceTimeout = monitor.sourceTimeout;
    source = node.read(name + ".", monitorSourceKeys(), ignoredCollisionMonitorKeys(), source);
    source.name = name;
    monitor.sources.push_back(std::move(source));
  }
  for (const std::string& name :
       uniquePluginNames(node, "exclusion_zones", monitor.exclusionZones)) {
    readZone(node, name, frames, monitor.zones);
  }
  reportProblems(node, problemsOf(monitor));
  node.finish();
  return monitor;
}

}  // namespace

void readMotionServers(Nav2Parameters& to,
                       const std::function<NodeReader(const std::string&)>& reader,
                       const ParameterFile& file) {
  const bool isPreHumble = file.hasNode("recoveries_server") && !file.hasNode("behavior_server");
  readBehaviors(reader(isPreHumble ? "recoveries_server" : "behavior_server"), to.behaviors);
  to.velocitySmoother = readVelocitySmoother(reader("velocity_smoother"));
  if (file.hasNode("collision_monitor")) {
    to.collisionMonitor = readCollisionMonitor(reader("collision_monitor"), to.frames);
  }
}

namespace {

/// Reads the keys of one plugin. The costs of classes have the names that semantic_classes lists.
template <class Parameters>
void readPlugin(NodeReader& node, const std::string& name, Parameters& parameters) {
  const std::string prefix = name + ".";
  parameters = node.read(prefix, keysOf(parameters), {}, parameters);
  if constexpr (std::is_same_v<Parameters, SemanticScorerParameters>) {
    for (const std::string& one : parameters.semanticClasses) {
      parameters.costs[one] = node.value<double>(prefix + one).value_or(0.0);
    }
  }
  if constexpr (std::is_same_v<Parameters, AdjustSpeedLimitParameters>) {
    node.markIgnored(prefix + "speed_limit_topic",
                     "the limit is passed to the controller server directly");
  }
}

template <class Settings>
void readPlugins(NodeReader& node, const std::string& list, const std::vector<std::string>& names,
                 const PluginClasses<Settings>& known,
                 std::vector<std::pair<std::string, Settings>>& to) {
  for (const std::string& name : uniquePluginNames(node, list, names)) {
    // Without the list, Nav2 loads the classes of the default names.
    const std::string plugin =
        pluginClass(node, name, node.has(list) ? std::string() : "nav2_route::" + name);
    if (plugin.empty()) {
      continue;
    }
    std::optional<Settings> settings = defaultsOf(known, plugin);
    if (!settings) {
      reportUnknownPlugin(node, name, plugin, namesOf(known));
      node.markIgnored(name + ".", "its class is not implemented");
      continue;
    }
    std::visit([&](auto& parameters) { readPlugin(node, name, parameters); }, *settings);
    to.emplace_back(name, *std::move(settings));
  }
}

}  // namespace

RouteSettings readRouteServer(NodeReader node) {
  RouteSettings route;
  route.server = node.read({}, routeServerKeys(), ignoredRouteServerKeys(), route.server);
  reportProblems(node, problemsOf(route.server));
  readPlugins(node, "edge_cost_functions", route.server.edgeCostFunctions, edgeScorerClasses(),
              route.scorers);
  readPlugins(node, "operations", route.server.operations, routeOperationClasses(),
              route.operations);
  node.finish();
  return route;
}

namespace {

/// Keys of nav2_map_server's map_server that publishes a mask.
struct MaskServer {
  std::string topic = "map", yaml;
};
const std::vector<Nav2Key<MaskServer>>& maskServerKeys() {
  static const std::vector<Nav2Key<MaskServer>> kKeys = {
      {"topic_name", &MaskServer::topic, "", "Topic of the mask."},
      {"yaml_filename", &MaskServer::yaml, "", "Mask: YAML file of a map."}};
  return kKeys;
}

/// Keys of nav2_map_server's costmap_filter_info_server.
struct FilterInfo {
  int type = 0;  // 0 keepout, 1 speed in percent, 2 speed in m/s, 3 binary
  std::string topic = "costmap_filter_info", maskTopic = "filter_mask";
  double base = 0.0, multiplier = 1.0;
};
const std::vector<Nav2Key<FilterInfo>>& filterInfoKeys() {
  static const std::vector<Nav2Key<FilterInfo>> kKeys = {
      {"type", &FilterInfo::type, "", "0 keepout, 1 speed in percent, 2 speed in m/s, 3 binary."},
      {"filter_info_topic", &FilterInfo::topic, "", "Topic that filters subscribe to."},
      {"mask_topic", &FilterInfo::maskTopic, "", "Topic of the mask."},
      {"base", &FilterInfo::base, "", "Value of the filter: base + multiplier * mask."},
      {"multiplier", &FilterInfo::multiplier, "", "See base."}};
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredMaskKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"frame_id", "the frames of all maps are identical"}};
  return kKeys;
}

/// "/mask" and "mask" are the same topic for a robot without a namespace.
std::string topicOf(const std::string& name) {
  return name.substr(std::min(name.size(), name.find_first_not_of('/')));
}

bool hasKey(const NodeParameters& node, const char* key) {
  return std::any_of(node.given.begin(), node.given.end(), [key](const GivenParameter& given) {
    return given.name == key && !given.isWildcard;
  });
}

bool isCostmap(const std::string& node) {
  return node == "local_costmap" || node == "global_costmap";
}

class MaskReader {
 public:
  MaskReader(const std::function<NodeReader(const std::string&)>& reader,
             const ParameterFile& file) {
    std::set<std::string> seen;
    for (const NodeParameters& node : file.nodes()) {
      if (isCostmap(node.node) || !seen.insert(node.node).second) {
        continue;
      }
      if (hasKey(node, "filter_info_topic")) {
        infos_.push_back(read(reader(node.node), filterInfoKeys(), FilterInfo()));
      } else if (hasKey(node, "yaml_filename") && node.node != "map_server") {
        servers_.push_back(read(reader(node.node), maskServerKeys(), MaskServer()));
      }
    }
  }

  void assignMasks(std::vector<CostmapPlugin>& filters) const {
    for (CostmapPlugin& filter : filters) {
      if (auto* const keepout = std::get_if<KeepoutFilterParameters>(&filter.parameters)) {
        assignMask(*keepout, 0, 0);
      } else if (auto* const speed = std::get_if<SpeedFilterParameters>(&filter.parameters)) {
        if (const FilterInfo* const info = assignScaledMask(*speed, 1, 2)) {
          speed->maskIsPercentage = info->type == 1;
        }
      } else if (auto* const binary = std::get_if<BinaryFilterParameters>(&filter.parameters)) {
        assignScaledMask(*binary, 3, 3);
      }
    }
  }

 private:
  template <class Parameters>
  static Parameters read(NodeReader node, const std::vector<Nav2Key<Parameters>>& keys,
                         Parameters parameters) {
    parameters = node.read({}, keys, ignoredMaskKeys(), std::move(parameters));
    node.finish();
    return parameters;
  }

  /// The filter info on a topic whose type is in [lowest, highest]; Nav2's filters reject other
  /// types.
  const FilterInfo* infoOf(const std::string& topic, int lowest, int highest) const {
    const FilterInfo* const found = base::findIf(infos_, [&](const FilterInfo& info) {
      return topicOf(info.topic) == topicOf(topic) && info.type >= lowest && info.type <= highest;
    });
    return topic.empty() ? nullptr : found;
  }

  /// Assigns the mask on the filter's topic, whose type is in [lowest, highest]; null: there is
  /// none, or the filter has its own.
  template <class Filter>
  const FilterInfo* assignMask(Filter& filter, int lowest, int highest) const {
    const FilterInfo* const info = infoOf(filter.filterInfoTopic, lowest, highest);
    filter.isMaskPublished = false;
    if (!filter.maskFile.empty() || info == nullptr) {
      return nullptr;
    }
    const MaskServer* const server = base::findIf(servers_, [&](const MaskServer& each) {
      return topicOf(each.topic) == topicOf(info->maskTopic);
    });
    filter.maskFile = server == nullptr ? std::string() : server->yaml;
    filter.isMaskPublished = !filter.maskFile.empty();
    return filter.isMaskPublished ? info : nullptr;
  }

  template <class Filter>
  const FilterInfo* assignScaledMask(Filter& filter, int lowest, int highest) const {
    const FilterInfo* const info = assignMask(filter, lowest, highest);
    if (info != nullptr) {
      filter.maskBase = info->base;
      filter.maskMultiplier = info->multiplier;
    }
    return info;
  }

  std::vector<FilterInfo> infos_;
  std::vector<MaskServer> servers_;
};

}  // namespace

void readMasks(Nav2Parameters& to, const std::function<NodeReader(const std::string&)>& reader,
               const ParameterFile& file) {
  const MaskReader masks(reader, file);
  masks.assignMasks(to.localCostmap.filters);
  masks.assignMasks(to.globalCostmap.filters);
}

}  // namespace sim2d::nav2
