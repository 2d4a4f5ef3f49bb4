#include "app/run/Nav2Robots.h"

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "app/run/DataPaths.h"
#include "app/run/PlannerFiles.h"
#include "bt/robot/FirstPlugins.h"
#include "bt/robot/Nav2Files.h"
#include "bt/robot/Nav2Servers.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Ranges.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace app {

namespace {

bool isNav2(const sim2d::Robot& robot) {
  return robot.planner == sim2d::kNav2Planner;
}

/// Without topics.
sim2d::Nav2Config choiceOf(const sim2d::Robot& robot) {
  return {robot.nav2Params, robot.nav2Tree.value_or(""), robot.nav2Distro, robot.nav2Values};
}

bt::Nav2Loaded loadedFor(const sim2d::Robot& robot, const std::string& scenarioPath) {
  sim2d::Nav2Config choice = choiceOf(robot);
  choice.topics = robot.nav2Topics.value_or("");
  return bt::loadNav2(choice, plannerFolderOf(scenarioPath), robot.name, shippedNav2Folders());
}

/// Calls `visit` with each listed robot of planner nav2 and its files.
template <class Visit>
void forEachNav2(const sim2d::Scenario& scenario, const std::string& scenarioPath, Visit visit) {
  sim2d::forEachListed(scenario.robots, [&](const sim2d::Robot& robot) {
    if (isNav2(robot)) {
      visit(robot, loadedFor(robot, scenarioPath));
    }
  });
}

/// The scenario with its listed robots of planner nav2 as `change` returns them; nullopt:
/// unchanged.
template <class Change>
std::shared_ptr<const sim2d::Scenario> withChangedRobots(
    const std::shared_ptr<const sim2d::Scenario>& scenario, Change change) {
  std::shared_ptr<sim2d::Scenario> changed;
  for (std::size_t i = 0; i < scenario->robots.size(); ++i) {
    const sim2d::Robot& robot = scenario->robots[i];
    std::optional<sim2d::Robot> next = robot.listed && isNav2(robot) ? change(robot) : std::nullopt;
    if (next) {
      changed = changed != nullptr ? changed : std::make_shared<sim2d::Scenario>(*scenario);
      changed->robots[i] = *std::move(next);
    }
  }
  return changed != nullptr ? changed : scenario;
}

}  // namespace

bt::Nav2Folders shippedNav2Folders() {
  return {shippedResources("nav2_params"), shippedResources("nav2_trees")};
}

base::Diagnostics wrongNav2Values(const sim2d::Scenario& scenario,
                                  const std::string& scenarioPath) {
  base::Diagnostics wrong;
  sim2d::forEachListed(scenario.robots, [&](const sim2d::Robot& robot) {
    if (isNav2(robot) && !robot.nav2Values.empty()) {
      base::append(wrong, loadedFor(robot, scenarioPath).invalidValues);
    }
  });
  return wrong;
}

std::shared_ptr<const sim2d::Scenario> withNav2GoalRadius(
    const std::shared_ptr<const sim2d::Scenario>& scenario, const std::string& scenarioPath,
    base::Diagnostics& unread) {
  return withChangedRobots(scenario, [&](const sim2d::Robot& robot) {
    std::optional<sim2d::Robot> changed;
    if (robot.goalRadius) {
      return changed;
    }
    const bt::Nav2Loaded loaded = loadedFor(robot, scenarioPath);
    if (loaded.ok()) {
      changed = robot;
      // The navigator decides with its own tolerance, which may be 0 or less.
      changed->goalRadius = std::clamp(sim2d::nav2::xyGoalTolerance(loaded.parameters),
                                       base::kLength.low, base::kLength.high);
    } else {
      base::append(unread, loaded.problems);
    }
    return changed;
  });
}

namespace {

/// The tree in use: the route tree if there are several goals.
const std::string& treeOf(const sim2d::Robot& robot, const bt::Nav2Loaded& loaded) {
  const bool isRoute = robot.goal.goals.size() > 1 && !loaded.throughPosesFile.empty();
  return isRoute ? loaded.throughPosesFile : loaded.treeFile;
}

}  // namespace

base::Diagnostics unlistedNav2Trees(const sim2d::Scenario& scenario,
                                    const std::string& scenarioPath,
                                    const std::vector<std::string>& inputs) {
  const auto isListed = [&inputs](const std::string& file) {
    return std::find(inputs.begin(), inputs.end(), file) != inputs.end();
  };
  base::Diagnostics unlisted;
  forEachNav2(scenario, scenarioPath, [&](const sim2d::Robot& robot, const bt::Nav2Loaded& loaded) {
    const std::string& tree = treeOf(robot, loaded);
    const bool areListed =
        std::all_of(loaded.paramsFiles.begin(), loaded.paramsFiles.end(), isListed);
    if (areListed && !loaded.paramsFiles.empty() && !tree.empty() && !isListed(tree)) {
      unlisted.push_back(base::error("nav2.read-late", {tree}, loaded.paramsFiles.front()));
    }
  });
  return unlisted;
}

std::vector<std::string> nav2FilesOf(const sim2d::Scenario& scenario,
                                     const std::string& scenarioPath) {
  std::vector<std::string> files;
  forEachNav2(scenario, scenarioPath, [&](const sim2d::Robot& robot, const bt::Nav2Loaded& loaded) {
    files.insert(files.end(), loaded.paramsFiles.begin(), loaded.paramsFiles.end());
    if (const std::string& tree = treeOf(robot, loaded); !tree.empty()) {
      files.push_back(tree);
    }
    files.insert(files.end(), loaded.masks.files.begin(), loaded.masks.files.end());
    files.insert(files.end(), loaded.subTreeFiles.begin(), loaded.subTreeFiles.end());
    if (!loaded.graph.file.empty()) {
      files.push_back(loaded.graph.file);
    }
    files.insert(files.end(), loaded.lattices.begin(), loaded.lattices.end());
  });
  return files;
}

namespace {

/// Trees that the files name and that do not exist; plugins that are used with Nav2's own tree.
base::Diagnostics treeProblems(const sim2d::nav2::Nav2Parameters& parameters) {
  base::Diagnostics problems;
  const sim2d::nav2::BtNavigatorParameters& navigator = parameters.btNavigator;
  for (const auto& [parameter, named, usual] :
       {std::tuple("default_nav_to_pose_bt_xml", navigator.defaultNavToPoseBtXml,
                   bt::kDefaultNav2Tree),
        std::tuple("default_nav_through_poses_bt_xml", navigator.defaultNavThroughPosesBtXml,
                   bt::kDefaultThroughPosesTree)}) {
    const std::string file = bt::nav2TreeOfParameter(parameters, {parameter, named, usual}, {},
                                                     shippedNav2Folders(), problems);
    if (usual == std::string(bt::kDefaultNav2Tree) &&
        bt::isNav2sOwnTree(file, shippedNav2Folders())) {
      base::append(problems, bt::firstPluginWarnings(parameters));
    }
  }
  return problems;
}

}  // namespace

base::Diagnostics checkNav2Files(const std::vector<std::string>& entries, Nav2Branch branch) {
  const bt::Nav2ParamFiles files(entries, {}, shippedNav2Folders());
  base::Diagnostics found = files.problems();
  if (base::hasErrors(found)) {
    return found;
  }
  base::Diagnostics wrong;
  sim2d::nav2::Nav2ReadResult reading = files.read({}, {branch, {}}, wrong);
  base::append(found, wrong);
  base::append(found, reading.problems);
  base::append(found, treeProblems(reading.parameters));
  base::append(found, bt::loadNav2Lattices(reading.parameters).problems);
  base::append(found, bt::nav2Inconsistencies(reading.parameters, nullptr));
  const bt::Nav2Masks masks = bt::loadNav2Masks(reading.parameters);
  base::append(found, masks.problems);
  base::append(found, bt::loadNav2RouteGraph(reading.parameters).problems);
  const bt::Nav2Servers::Setup setup{reading.parameters, {},          {}, {}, 1, -1,
                                     masks.local,        masks.global};
  const bool canBeMade = !base::hasErrors(found) && !reading.parameters.isPartial;
  const base::Diagnostics reported = found;  // controllers are checked when the file is read
  for (const base::Diagnostic& problem : canBeMade ? bt::Nav2Servers::make(setup).diagnostics()
                                                   : bt::Nav2Servers::costmapProblems(setup)) {
    const bool isReported =
        std::any_of(reported.begin(), reported.end(), [&](const base::Diagnostic& each) {
          return each.code == problem.code && each.line == problem.line &&
                 each.file == problem.file;
        });
    const bool isElsewhere = reading.parameters.isPartial && problem.line == 0;  // in another file
    if (!isReported && !isElsewhere && problem.code != "nav2.no-map") {  // scenarios name maps
      found.push_back(problem);
    }
  }
  base::append(found, bt::nav2Hints(reading.parameters));
  return found;
}

base::Diagnostics checkNavigatorTree(const std::string& path, Nav2Branch branch) {
  sim2d::nav2::Nav2Parameters parameters;
  parameters.distro = branch.value_or(sim2d::nav2::Distro::Main);
  base::Diagnostics found = bt::loadNavigatorTree(path, parameters).problems;
  if (!branch) {  // a tree does not name its branch
    found.erase(std::remove_if(found.begin(), found.end(),
                               [](const base::Diagnostic& problem) {
                                 return problem.code == "nav2.node-of-others" ||
                                        problem.code == "nav2.port-of-others";
                               }),
                found.end());
  }
  return found;
}

// Displays and changes parameters of Nav2 for forms.

namespace {

using sim2d::nav2::EffectiveKey;

bt::Nav2Loaded loadParameters(const sim2d::Robot& robot, const std::string& scenarioPath) {
  return bt::loadNav2Parameters(choiceOf(robot), plannerFolderOf(scenarioPath), robot.name,
                                shippedNav2Folders());
}

std::string withoutNode(const EffectiveKey& key) {
  return key.path.substr(key.node.size() + 1);
}

bool names(const std::string& given, const Nav2Parameter& parameter) {
  return given == parameter.path || given == parameter.node + "." + parameter.name;
}

}  // namespace

Nav2ParameterList nav2ParameterListOf(const sim2d::Robot& robot, const std::string& scenarioPath) {
  Nav2ParameterList sheet;
  const bt::Nav2Loaded now = loadParameters(robot, scenarioPath);
  sheet.file = base::join(now.paramsFiles, ", ");
  sheet.problems = now.problems;
  sim2d::Robot plain = robot;
  plain.nav2Values.clear();
  std::map<std::string, std::string> fileValue;  // by path
  const bt::Nav2Loaded before = loadParameters(plain, scenarioPath);
  for (const EffectiveKey& key : before.parameters.notes.known) {
    if (key.isGiven) {
      fileValue.emplace(key.path, key.value);
    }
  }
  std::map<std::string, int> uses;  // nodes per parameter name
  for (const EffectiveKey& key : now.parameters.notes.known) {
    ++uses[withoutNode(key)];
  }
  for (const EffectiveKey& key : now.parameters.notes.known) {
    Nav2Parameter& parameter = sheet.parameters.emplace_back();
    parameter.node = key.node;
    parameter.name = withoutNode(key);
    parameter.path = uses[parameter.name] == 1 ? parameter.name : key.path;
    parameter.type = key.type;
    parameter.unit = key.unit;
    parameter.meaning = key.meaning;
    parameter.fallback = key.fallback;
    if (const auto found = fileValue.find(key.path); found != fileValue.end()) {
      parameter.fileValue = found->second;
    }
    for (const auto& [path, yaml] : robot.nav2Values) {
      parameter.given = names(path, parameter) ? std::optional(yaml) : parameter.given;
    }
  }
  return sheet;
}

sim2d::Robot withNav2Value(sim2d::Robot robot, const Nav2Parameter& parameter,
                           std::optional<std::string> yaml) {
  sim2d::ParameterTexts& values = robot.nav2Values;
  const auto isIt = [&](const auto& each) { return names(each.first, parameter); };
  if (!yaml) {
    values.erase(std::remove_if(values.begin(), values.end(), isIt), values.end());
  } else if (auto* const found = base::findIf(values, isIt)) {
    found->second = *std::move(yaml);
  } else {
    values.emplace_back(parameter.path, *std::move(yaml));
  }
  return robot;
}

std::string nav2ValueProblem(const sim2d::Robot& robot, const std::string& scenarioPath,
                             const Nav2Parameter& parameter, const std::string& yaml) {
  const bt::Nav2Loaded before = loadParameters(robot, scenarioPath);
  const bt::Nav2Loaded after = loadParameters(withNav2Value(robot, parameter, yaml), scenarioPath);
  for (const base::Diagnostics* const found : {&after.invalidValues, &after.problems}) {
    const base::Diagnostics& old =
        found == &after.problems ? before.problems : before.invalidValues;
    for (const base::Diagnostic& problem : *found) {
      const bool isNew = std::none_of(old.begin(), old.end(), [&](const base::Diagnostic& each) {
        return each.code == problem.code && each.values == problem.values;
      });
      if (problem.severity == base::Severity::Error && isNew) {
        return problem.message;
      }
    }
  }
  return {};
}

namespace {

constexpr const char* kNoBody = "nav2.no-body";

bool isGiven(const sim2d::nav2::Nav2Parameters& parameters, const std::string& path) {
  const auto* const key = base::findBy(parameters.notes.known, &EffectiveKey::path, path);
  return key != nullptr && key->isGiven;
}

void takeFootprint(const sim2d::nav2::Polygon& corners, sim2d::Robot& robot) {
  robot.radius.reset();
  robot.footprintX.clear();
  robot.footprintY.clear();
  for (const base::Vec2& corner : corners) {
    robot.footprintX.push_back(corner.x());
    robot.footprintY.push_back(corner.y());
  }
}

}  // namespace

base::Result<sim2d::Robot> withNav2Body(sim2d::Robot robot, const std::string& scenarioPath) {
  const bt::Nav2Loaded loaded = loadParameters(robot, scenarioPath);
  if (base::hasErrors(loaded.problems)) {
    return loaded.problems;
  }
  const sim2d::nav2::CostmapParameters& costmap = loaded.parameters.localCostmap.parameters;
  if (!costmap.footprint.empty() && costmap.footprint != "[]") {
    const base::Result<sim2d::nav2::Polygon> corners = sim2d::nav2::readPolygon(costmap.footprint);
    if (!corners) {
      return corners.diagnostics();
    }
    takeFootprint(*corners, robot);
    return robot;
  }
  if (!isGiven(loaded.parameters, "local_costmap.robot_radius")) {
    return base::error(kNoBody, {robot.name, base::join(loaded.paramsFiles, ", ")});
  }
  takeFootprint({}, robot);
  robot.radius = costmap.robotRadius;
  return robot;
}

std::shared_ptr<const sim2d::Scenario> withNav2Bodies(
    const std::shared_ptr<const sim2d::Scenario>& scenario, const std::string& scenarioPath,
    base::Diagnostics& problems) {
  return withChangedRobots(scenario, [&](const sim2d::Robot& robot) {
    std::optional<sim2d::Robot> changed;
    if (!robot.nav2Body.value_or(false)) {
      return changed;
    }
    base::Result<sim2d::Robot> shaped = withNav2Body(robot, scenarioPath);
    for (base::Diagnostic problem : shaped ? base::Diagnostics() : shaped.diagnostics()) {
      if (problem.code == kNoBody) {
        problem.severity = base::Severity::Warning;
        problem.entity = robot.key;
        problems.push_back(std::move(problem));
      }
    }
    if (shaped) {
      changed = *std::move(shaped);
    }
    return changed;
  });
}

sim2d::Registries builtinRegistries() {
  sim2d::Registries all = sim2d::builtinRegistries();
  bt::addNav2(all.planners, shippedNav2Folders());
  return all;
}

std::vector<std::string> listedPlanners(const sim2d::Registries& registries) {
  const auto groupOf = [](const std::string& name) {
    const bool isExternal = name == sim2d::kExternalPlanner || name == sim2d::kLibraryPlanner ||
                            name == sim2d::kOnnxPlanner || name == "ros2";
    return isExternal ? 2 : name == sim2d::kNav2Planner ? 1 : 0;
  };
  std::vector<std::string> names = registries.planners.names();
  std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return std::pair(groupOf(a), a) < std::pair(groupOf(b), b);
  });
  return names;
}

std::shared_ptr<const sim2d::Registries> sharedRegistries() {
  return std::make_shared<const sim2d::Registries>(builtinRegistries());
}

}  // namespace app
