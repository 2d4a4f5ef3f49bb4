#include "app/run/Nav2Robots.h"

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include "app/run/DataPaths.h"
#include "app/run/PlannerFiles.h"
#include "bt/robot/Nav2ParamFiles.h"
#include "bt/robot/Nav2Report.h"
#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/Planner.h"

namespace app {

namespace {

bool isNav2(const sim2d::Robot& robot) {
  return robot.planner == sim2d::kNav2Planner;
}

sim2d::Nav2Choice choiceOf(const sim2d::Robot& robot) {
  return {robot.nav2Params, robot.nav2Tree.value_or(""), robot.nav2Distro, robot.nav2Values,
          robot.nav2Topics.value_or("")};
}

bt::Nav2Loaded loadedFor(const sim2d::Robot& robot, const std::string& scenarioPath) {
  return bt::loadNav2(choiceOf(robot), folderOfPlanners(scenarioPath), robot.name, shippedNav2());
}

}  // namespace

bt::Nav2Folders shippedNav2() {
  return {shippedResources("nav2_params"), shippedResources("nav2_trees")};
}

base::Diagnostics wrongNav2Values(const sim2d::Scenario& scenario,
                                  const std::string& scenarioPath) {
  base::Diagnostics wrong;
  sim2d::forEachListed(scenario.robots, [&](const sim2d::Robot& robot) {
    if (isNav2(robot) && !robot.nav2Values.empty()) {
      base::append(wrong, loadedFor(robot, scenarioPath).wrongValues);
    }
  });
  return wrong;
}

std::shared_ptr<const sim2d::Scenario> withNav2GoalRadius(
    const std::shared_ptr<const sim2d::Scenario>& scenario, const std::string& scenarioPath,
    base::Diagnostics& unread) {
  std::shared_ptr<sim2d::Scenario> changed;
  for (std::size_t i = 0; i < scenario->robots.size(); ++i) {
    const sim2d::Robot& robot = scenario->robots[i];
    if (!robot.listed || !isNav2(robot) || robot.goalRadius) {
      continue;
    }
    const bt::Nav2Loaded loaded = loadedFor(robot, scenarioPath);
    if (loaded.ok()) {
      changed = changed != nullptr ? changed : std::make_shared<sim2d::Scenario>(*scenario);
      changed->robots[i].goalRadius = sim2d::nav2::xyGoalTolerance(loaded.parameters);
    } else {
      base::append(unread, loaded.problems);
    }
  }
  return changed != nullptr ? changed : scenario;
}

namespace {

/// The tree that drives: that of a route where there are several goals.
const std::string& treeOf(const sim2d::Robot& robot, const bt::Nav2Loaded& loaded) {
  const bool isRoute = robot.goal.goals.size() > 1 && !loaded.throughFile.empty();
  return isRoute ? loaded.throughFile : loaded.treeFile;
}

}  // namespace

base::Diagnostics unlistedNav2Trees(const sim2d::Scenario& scenario,
                                    const std::string& scenarioPath,
                                    const std::vector<std::string>& inputs) {
  const auto isListed = [&inputs](const std::string& file) {
    return std::find(inputs.begin(), inputs.end(), file) != inputs.end();
  };
  base::Diagnostics unlisted;
  sim2d::forEachListed(scenario.robots, [&](const sim2d::Robot& robot) {
    if (!isNav2(robot)) {
      return;
    }
    const bt::Nav2Loaded loaded = loadedFor(robot, scenarioPath);
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
  sim2d::forEachListed(scenario.robots, [&](const sim2d::Robot& robot) {
    if (!isNav2(robot)) {
      return;
    }
    const bt::Nav2Loaded loaded = loadedFor(robot, scenarioPath);
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

/// Trees that the files name and that are not found.
base::Diagnostics missingTrees(const sim2d::nav2::Nav2Parameters& parameters) {
  base::Diagnostics missing;
  const sim2d::nav2::BtNavigatorParameters& navigator = parameters.btNavigator;
  for (const auto& [parameter, named, usual] :
       {std::tuple("default_nav_to_pose_bt_xml", navigator.defaultNavToPoseBtXml,
                   bt::kUsualNav2Tree),
        std::tuple("default_nav_through_poses_bt_xml", navigator.defaultNavThroughPosesBtXml,
                   bt::kUsualThroughTree)}) {
    bt::nav2TreeOfParameter(parameters, {parameter, named, usual}, {}, shippedNav2(), missing);
  }
  return missing;
}

}  // namespace

base::Diagnostics checkNav2Files(const std::vector<std::string>& entries, Nav2Branch branch) {
  const bt::Nav2ParamFiles files(entries, {}, shippedNav2());
  base::Diagnostics found = files.problems();
  if (base::hasErrors(found)) {
    return found;
  }
  base::Diagnostics wrong;
  sim2d::nav2::Nav2Reading reading = files.read({}, {branch, {}}, wrong);
  base::append(found, wrong);
  base::append(found, reading.problems);
  base::append(found, missingTrees(reading.parameters));
  base::append(found, bt::loadNav2Lattices(reading.parameters).problems);
  base::append(found, bt::nav2Contradictions(reading.parameters, nullptr));
  const bt::Nav2Masks masks = bt::loadNav2Masks(reading.parameters);
  base::append(found, masks.problems);
  base::append(found, bt::loadNav2Graph(reading.parameters).problems);
  const bt::Nav2Servers::Setup setup{reading.parameters, {},          {}, {}, 1, -1,
                                     masks.local,        masks.global};
  const bool canBeMade = !base::hasErrors(found) && !reading.parameters.isPartial;
  const base::Diagnostics reported = found;  // controllers are checked as the file is read
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
  base::append(found, bt::nav2Remarks(reading.parameters));
  return found;
}

base::Diagnostics checkNav2File(const std::string& path, Nav2Branch branch) {
  return checkNav2Files({path}, branch);
}

base::Diagnostics checkNavigatorTree(const std::string& path, Nav2Branch branch) {
  sim2d::nav2::Nav2Parameters parameters;
  parameters.distro = branch.value_or(sim2d::nav2::Distro::Main);
  base::Diagnostics found = bt::loadNavigatorTree(path, parameters).problems;
  if (!branch) {  // nothing in a tree names its branch
    found.erase(std::remove_if(found.begin(), found.end(),
                               [](const base::Diagnostic& problem) {
                                 return problem.code == "nav2.node-of-others" ||
                                        problem.code == "nav2.port-of-others";
                               }),
                found.end());
  }
  return found;
}

}  // namespace app
