#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace sim2d {
namespace {

template <class T, class U>
void drop(std::optional<T>& value, const U& fallback) {
  if (value && *value == fallback) {
    value.reset();
  }
}

void dropPerson(PersonExtension& person, const DesktopSettings& desktop) {
  drop(person.startTime, 0.0);
  drop(person.mass, massOf(person.kind.value_or(PersonKind::Adult)));
  drop(person.kind, PersonKind::Adult);
  drop(person.model, desktop.model.value_or("sfm"));
  drop(person.route, desktop.route.value_or(Route::Planned));
  drop(person.atEnd, AtEnd::Stop);
}

/// Limits and body are the type's; those of another type are not known here.
void dropRobot(Robot& robot) {
  const ResolvedRobot generic;
  drop(robot.type, generic.type);
  drop(robot.planner, generic.planner);
  drop(robot.goalRadius, generic.goalRadius);
  drop(robot.startTime, generic.startTime);
  if (!robot.type) {
    drop(robot.radius, generic.radius);
    drop(robot.mass, generic.mass);
    drop(robot.maxVel, generic.maxVel);
    drop(robot.maxAcc, generic.maxAcc);
    drop(robot.maxOmega, generic.maxOmega);
    drop(robot.maxAlpha, generic.maxAlpha);
  }
}

void dropSettings(DesktopSettings& desktop) {
  drop(desktop.mapRule, "humble");
  drop(desktop.seed, 1);
  drop(desktop.dt, 0.05);
  drop(desktop.recordEvery, 1);
  drop(desktop.model, "sfm");
  drop(desktop.route, Route::Planned);
  drop(desktop.obstaclePoints, ObstaclePoints::Boundary);
  drop(desktop.loopTrees, true);
  drop(desktop.metrics.from, "begin");
  drop(desktop.metrics.until, "end");
  drop(desktop.metrics.frequency, 0.0);
  drop(desktop.metrics.tag, "exp_1");
  drop(desktop.metrics.runId, 0);
}

}  // namespace

Scenario withoutDefaults(const Scenario& scenario) {
  Scenario result = scenario;
  for (Human& human : result.humans) {
    dropPerson(human.ours, result.desktop);
  }
  dropSettings(result.desktop);
  for (Robot& robot : result.robots) {
    dropRobot(robot);
  }
  for (Obstacle& obstacle : result.obstacles) {
    drop(obstacle.thickness, 0.1);
  }
  for (Door& door : result.doors) {
    drop(door.thickness, 0.05);
    drop(door.open, true);
  }
  for (Area& area : result.areas) {
    drop(area.from, 0.0);
  }
  return result;
}

}  // namespace sim2d
