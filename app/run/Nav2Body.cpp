#include "app/run/Nav2Body.h"

#include <utility>

#include "app/run/Nav2Robots.h"
#include "app/run/PlannerFiles.h"
#include "bt/robot/Nav2Files.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

namespace app {
namespace {

constexpr const char* kNoBody = "nav2.no-body";

bool isGiven(const sim2d::nav2::Nav2Parameters& parameters, const std::string& path) {
  for (const sim2d::nav2::KnownKey& key : parameters.notes.known) {
    if (key.path == path) {
      return key.isGiven;
    }
  }
  return false;
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
  const sim2d::Nav2Choice choice{robot.nav2Params, {}, robot.nav2Distro, robot.nav2Values};
  const bt::Nav2Loaded loaded =
      bt::loadNav2Parameters(choice, folderOfPlanners(scenarioPath), robot.name, shippedNav2());
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
  std::shared_ptr<sim2d::Scenario> changed;
  for (std::size_t i = 0; i < scenario->robots.size(); ++i) {
    const sim2d::Robot& robot = scenario->robots[i];
    if (!robot.listed || robot.planner != sim2d::kNav2Planner || !robot.nav2Body.value_or(false)) {
      continue;
    }
    base::Result<sim2d::Robot> shaped = withNav2Body(robot, scenarioPath);
    if (shaped) {
      changed = changed != nullptr ? changed : std::make_shared<sim2d::Scenario>(*scenario);
      changed->robots[i] = *std::move(shaped);
      continue;
    }
    for (base::Diagnostic problem : shaped.diagnostics()) {
      if (problem.code == kNoBody) {
        problem.severity = base::Severity::Warning;
        problem.entity = robot.key;
        problems.push_back(std::move(problem));
      }
    }
  }
  return changed != nullptr ? changed : scenario;
}

}  // namespace app
