#include "sim2d/nav/nav2/params/Nav2Parameters.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <set>
#include <tuple>
#include <utility>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/control/ControllerServer.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "sim2d/nav/nav2/params/NodeReader.h"
#include "sim2d/nav/nav2/params/RosValue.h"
#include "sim2d/nav/nav2/params/ServerParameterReader.h"

namespace sim2d::nav2 {
namespace {

constexpr const char* kDefaultPlanner = "nav2_navfn_planner::NavfnPlanner";
constexpr const char* kDefaultSmoother = "nav2_smoother::SimpleSmoother";

/// The planner that replaces one of another package: the one whose name is similar, else NavFn.
std::string similarPlanner(const std::string& type) {
  const auto has = [&type](const char* part) { return type.find(part) != std::string::npos; };
  return has("Hybrid") || has("Lattice") ? "nav2_smac_planner::SmacPlannerHybrid"
         : has("Smac")                   ? "nav2_smac_planner::SmacPlanner2D"
         : has("Theta")                  ? "nav2_theta_star_planner::ThetaStarPlanner"
                                         : kDefaultPlanner;
}

/// Plugins of a server: the key of their list, the class without a list, and the known classes.
template <class Parameters>
struct PluginKind {
  const char* list;
  const char* standard;
  PluginLookup<Parameters> (*lookup)(const std::string& type, Distro distro);
  std::string (*similar)(const std::string& type);  // of this program, for other packages' classes
  std::vector<std::string> known;
};

/// Reads the nodes of a file one by one.
class Nav2FileReader {
 public:
  Nav2FileReader(const ParameterFile& file, const Nav2ReadOptions& options, Nav2Parameters& to)
      : file_(file), options_(options), to_(to), isPreHumble_(file.hasNode("recoveries_server")) {
    to_.notes.onlyKeys = options.onlyKeys;
  }

  void read() {
    to_.nodeNames = listNodes();
    to_.frames = frameNamesOf(file_, options_.robot);
    readCostmaps();
    readControllers();
    readPlanners();
    readSmoothers();
    const auto start = [this](const std::string& node) { return reader(node); };
    readMotionServers(to_, start, file_);
    readNavigator();
    readRoutes();
    readDocking(to_, start, file_);
    readMasks(to_, start, file_);
    recordOtherNodes();
  }

 private:
  NodeReader reader(const std::string& node) {
    readNames_.insert(node);
    NodeReader made(file_.parametersOf(node, options_.robot), to_.distro, to_.notes);
    renameLegacyKeys(made, isPreHumble_);
    fillMissingLists(made);
    return made;
  }

  void readCostmaps() {
    NodeReader local = reader("local_costmap");
    to_.localCostmap = readCostmap(local);
    local.finish();
    NodeReader global = reader("global_costmap");
    to_.globalCostmap = readCostmap(global);
    global.finish();
  }

  void readControllers() {
    NodeReader node = reader("controller_server");
    to_.isPartial = !hasController(node);
    if (to_.isPartial) {
      reportPartialFile(node);
    }
    replaceControllerPlugins(node, velocitySmootherLimits(file_, options_.robot));
    to_.controllerServer = node.read({}, controllerServerNodeKeys(node.given({}), to_.distro));
    if (!options_.onlyKeys && !to_.isPartial) {
      const auto made = makeControllerServer(to_.controllerServer, to_.distro);
      reportProblems(node, made.diagnostics());
    }
    node.finish();
  }

  /// Without a class Nav2 uses DWB, which then has no critics and does not start.
  static bool hasController(const NodeReader& node) {
    return node.has("controller_plugins") || node.has("FollowPath.plugin") ||
           node.has("FollowPath.critics");
  }

  /// An overlay or a file for other nodes: the plugin class that would read the keys is unknown.
  void reportPartialFile(NodeReader& node) {
    for (const GivenParameter& given : node.parameters().given) {
      if (given.name.find('.') != std::string::npos && !given.isWildcard) {
        node.markIgnored(given.name, "the class of its plugin is not in this file");
      }
    }
    const int line = file_.nodes().empty() ? 0 : file_.nodes().front().line;
    to_.notes.problems.push_back(
        base::warning("nav2.partial-file", {to_.nodeNames}, file_.file(), line));
  }

  std::string listNodes() const {
    std::vector<std::string> names;
    for (const NodeParameters& node : file_.nodes()) {
      if (std::find(names.begin(), names.end(), node.node) == names.end()) {
        names.push_back(node.node);
      }
    }
    constexpr std::size_t kNamed = 6;
    const bool isLong = names.size() > kNamed;
    names.resize(std::min(names.size(), kNamed));
    return base::join(names, ", ") + (isLong ? " …" : "");
  }

  /// Reads the plugins of a list. A class of another package is replaced by a similar one.
  template <class Parameters>
  void readPlugins(NodeReader& node, const PluginKind<Parameters>& kind,
                   const std::vector<std::string>& names,
                   std::vector<std::pair<std::string, Parameters>>& to) {
    const auto find = [&](const std::string& plugin) { return kind.lookup(plugin, to_.distro); };
    const bool isDefaultList = !node.has(kind.list);
    for (const std::string& name : uniquePluginNames(node, kind.list, names)) {
      std::string type = pluginClass(node, name, isDefaultList ? kind.standard : "");
      if (type.empty()) {
        continue;
      }
      const auto found = find(type);
      if (!found.parameters && found.why.empty()) {
        const std::string similar = kind.similar(type);
        const Nav2KeyTable keys = std::visit(
            [](const auto& held) { return keyTableOf(keysOf(held), held, ignoredKeysOf(held)); },
            *find(similar).parameters);
        type = substituteClass(node, name, type, kind.known, similar, keys);
      }
      readPluginBlock(node, name, type, find, kind.known, to);
    }
  }

  void readPlanners() {
    NodeReader node = reader("planner_server");
    const PlannerServerParameters defaults;
    to_.plannerServer = node.read({}, keysOf(defaults), ignoredKeysOf(defaults), defaults);
    const PluginKind<GlobalPlannerParameters> kind = {"planner_plugins", kDefaultPlanner,
                                                      globalPlannerPlugin, similarPlanner,
                                                      globalPlannerPluginNames()};
    readPlugins(node, kind, to_.plannerServer.plannerPlugins, to_.planners);
    node.finish();
  }

  void readSmoothers() {
    NodeReader node = reader("smoother_server");
    const SmootherServerParameters defaults;
    to_.smootherServer = node.read({}, keysOf(defaults), ignoredKeysOf(defaults), defaults);
    const PluginKind<PathSmootherParameters> kind = {
        "smoother_plugins", kDefaultSmoother, pathSmootherPlugin,
        [](const std::string&) -> std::string { return kDefaultSmoother; },
        pathSmootherPluginNames()};
    readPlugins(node, kind, to_.smootherServer.smootherPlugins, to_.smoothers);
    node.finish();
  }

  void readNavigator() {
    NodeReader node = reader("bt_navigator");
    to_.btNavigator =
        node.read({}, btNavigatorKeys(), ignoredBtNavigatorKeys(), BtNavigatorParameters());
    node.finish();
  }

  /// Without this node there is no graph, so its plugins have no effect.
  void readRoutes() {
    if (file_.hasNode("route_server")) {
      to_.route = readRouteServer(reader("route_server"));
    }
  }

  /// Records nodes that are ignored or unknown.
  void recordOtherNodes() {
    const std::vector<std::string> known(readNames_.begin(), readNames_.end());
    for (const NodeParameters& other : file_.nodes()) {
      if (other.node == "/**") {
        continue;
      }
      if (readNames_.count(other.node) != 0) {
        recordOtherRobotNode(other);
        continue;
      }
      readNames_.insert(other.node);
      NodeReader node(other, to_.distro, to_.notes);
      const char* const why = ignoredNodeReason(other.node);
      for (const GivenParameter& given : other.given) {
        node.markIgnored(given.name, why != nullptr ? why : "no node of Nav2 has this name");
      }
      if (why == nullptr) {
        base::Diagnostic problem =
            base::warning("nav2.unknown-node", {other.node, base::nearestName(other.node, known)},
                          other.file, other.line);
        to_.notes.problems.push_back(std::move(problem));
      }
    }
  }

  /// Records all keys of a node in another robot's namespace as ignored.
  void recordOtherRobotNode(const NodeParameters& node) {
    const auto ours = file_.nodesOf(node.node, options_.robot);
    if (std::find(ours.begin(), ours.end(), &node) != ours.end()) {
      return;
    }
    for (const GivenParameter& given : node.given) {
      to_.notes.keys.push_back({node.nameSpace + "/" + node.node + "." + given.name,
                                valueText(*given.value), given.value->line, given.value->column,
                                KeyUse::Ignored, "of another robot by its namespace", given.file});
    }
  }

  const ParameterFile& file_;
  const Nav2ReadOptions& options_;
  Nav2Parameters& to_;
  bool isPreHumble_;  // of a branch before Humble, according to its nodes
  std::set<std::string> readNames_;
};

const KeyUsage* keyAt(const ParameterNotes& notes, const std::string& path) {
  return base::findBy(notes.keys, &KeyUsage::path, path);
}

/// Sorts problems by file, line and column.
void sortByPosition(const std::vector<std::string>& files, base::Diagnostics& problems) {
  const auto placeOf = [&files](const base::Diagnostic& problem) {
    const auto file = std::find(files.begin(), files.end(), problem.file) - files.begin();
    return std::tuple(file, problem.line, problem.column);
  };
  std::stable_sort(problems.begin(), problems.end(),
                   [&](const base::Diagnostic& a, const base::Diagnostic& b) {
                     return placeOf(a) < placeOf(b);
                   });
}

}  // namespace

Nav2ReadResult readNav2Parameters(const ParameterFile& file, const Nav2ReadOptions& options) {
  Nav2ReadResult reading;
  Nav2Parameters& parameters = reading.parameters;
  parameters.file = file.file();
  parameters.files = file.files();
  parameters.isGuessed = !options.distro;
  if (options.distro) {
    parameters.distro = *options.distro;
  } else {
    DistroGuess guess = guessDistro(file);
    parameters.distro = guess.distro;
    parameters.distroReasons = std::move(guess.reasons);
  }
  Nav2FileReader(file, options, parameters).read();
  reading.problems = std::move(parameters.notes.problems);
  parameters.notes.problems.clear();
  sortByPosition(file.files(), reading.problems);
  return reading;
}

base::Diagnostic withFilePosition(const Nav2Parameters& parameters, base::Diagnostic problem) {
  std::string where;
  std::vector<std::string> paths;  // the most specific last
  for (const auto& [hole, value] : problem.values) {
    if (hole == "where") {
      where = base::join(where.empty() ? std::vector{value} : std::vector{where, value}, ".");
    }
  }
  const std::string prefix = where + ".";
  paths.push_back(prefix + "plugin");
  for (const auto& [hole, value] : problem.values) {
    paths.push_back(prefix + value + ".plugin");
  }
  for (const auto& [hole, value] : problem.values) {
    paths.push_back(prefix + value);
  }
  paths.push_back(where);
  const KeyUsage* key = nullptr;
  for (const std::string& path : paths) {
    const KeyUsage* const found = keyAt(parameters.notes, path);
    key = found != nullptr ? found : key;
  }
  const std::string node = where.substr(0, where.find('.'));
  problem.file = parameters.file;
  for (const NodeLocation& each : parameters.notes.nodes) {
    if (each.node == node && key == nullptr) {
      problem.line = each.line;
      problem.file = each.file;
    }
  }
  if (key != nullptr) {
    problem.line = key->line;
    problem.column = key->column;
    problem.file = key->file;  // empty: the value is set outside of the files
  }
  return problem;
}

std::vector<std::string> parameterFolders(const Nav2Parameters& parameters,
                                          const std::string& path) {
  std::vector<std::string> files = parameters.files;
  if (const KeyUsage* const key = keyAt(parameters.notes, path); key != nullptr) {
    files.insert(files.begin(), key->file);
  }
  std::vector<std::string> folders;
  for (const std::string& file : files) {
    std::string folder = std::filesystem::path(file).parent_path().string();
    if (!file.empty() && std::find(folders.begin(), folders.end(), folder) == folders.end()) {
      folders.push_back(std::move(folder));
    }
  }
  return folders;
}

base::Result<std::vector<ParameterName>> findNav2Parameters(const Nav2ReadResult& reading,
                                                            const std::string& path) {
  std::vector<std::string> known;  // with their nodes
  for (const KeyUsage& key : reading.parameters.notes.keys) {
    if (key.use == KeyUse::Used) {
      known.push_back(key.path);
    }
  }
  for (const DefaultedKey& fallback : reading.parameters.notes.defaults) {
    known.push_back(fallback.path);
  }
  std::vector<ParameterName> found;
  std::vector<std::string> names = known;
  const std::string end = "." + path;
  for (const std::string& full : known) {
    const std::size_t dot = full.find('.');
    names.push_back(full.substr(dot + 1));
    if (full == path || full.substr(dot) == end) {
      found.push_back({full.substr(0, dot), full.substr(dot + 1)});
    }
  }
  if (found.empty()) {
    return base::error("nav2.set-unknown", {path, base::nearestName(path, names)});
  }
  return found;
}

std::optional<base::YamlNode> parseNav2Value(const std::string& yaml) {
  base::Diagnostics problems;
  base::YamlNode value = base::parseYaml(yaml, {}, problems);
  return base::hasErrors(problems) || value.isNull() || value.isMap() ? std::nullopt
                                                                      : std::optional(value);
}

base::Diagnostics setNav2Value(ParameterFile& file, const Nav2ReadResult& reading,
                               const std::string& path, const std::string& yaml) {
  const base::Result<std::vector<ParameterName>> named = findNav2Parameters(reading, path);
  if (!named) {
    return named.diagnostics();
  }
  if (named->size() > 1) {
    std::vector<std::string> nodes;
    nodes.reserve(named->size());
    for (const ParameterName& each : *named) {
      nodes.push_back(each.node);
    }
    return {base::error("nav2.set-ambiguous", {path, base::join(nodes, ", ")})};
  }
  std::optional<base::YamlNode> value = parseNav2Value(yaml);
  if (!value) {
    return {base::withContext(path, base::error("set.no-value", {yaml}))};
  }
  file.set(named->front().node, named->front().name, *std::move(value));
  return {};
}

base::Diagnostics overrideNav2Value(ParameterFile& file, const Nav2ReadResult& reading,
                                    const ParameterOverride& given) {
  const std::string path = given.node.empty() ? given.name : given.node + "." + given.name;
  std::optional<base::YamlNode> value = parseNav2Value(given.yaml);
  if (given.name.empty() || !value) {
    return {base::withContext(path, base::error("set.no-value", {given.yaml}))};
  }
  if (!given.node.empty()) {
    file.override(given.node, given.name, *std::move(value));
    return {};
  }
  const base::Result<std::vector<ParameterName>> named = findNav2Parameters(reading, path);
  if (!named) {
    return named.diagnostics();
  }
  for (const ParameterName& each : *named) {
    file.override(each.node, each.name, *value);
  }
  return {};
}

double xyGoalTolerance(const Nav2Parameters& parameters) {
  const auto names = controllerValue<std::vector<std::string>>(parameters, "goal_checker_plugins",
                                                               {"goal_checker"});
  const std::string first = names.empty() ? std::string() : names.front();
  for (const char* const key :
       {".xy_goal_tolerance", ".along_path_tolerance", ".coarse_xy_goal_tolerance"}) {
    if (parameters.controllerServer.count(first + key) != 0) {
      return controllerValue(parameters, first + key, 0.25);
    }
  }
  return 0.25;
}

}  // namespace sim2d::nav2
