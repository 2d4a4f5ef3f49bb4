#include "sim2d/scenario/ScenarioCheck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <type_traits>

#include "sim2d/base/Problems.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/scenario/CheckParts.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

constexpr EntityId kScenario{base::EntityKind::Scenario, 0};

template <class T>
void collectNames(const std::vector<T>& entities, std::set<std::string>& seen,
                  CheckReport& report) {
  for (const T& entity : entities) {
    if constexpr (std::is_same_v<T, Human>) {
      if (entity.name.empty() || loaderKeys().count(entity.name) != 0) {
        report.error(entity.key, "scenario.bad-person-name", {entity.name});
      }
    } else if (!isEntityName(entity.name) || blockKeys().count(entity.name) != 0) {
      report.error(entity.key, "scenario.bad-name", {entity.name});
    }
    if (!seen.insert(entity.name).second) {
      report.error(entity.key, "scenario.name-twice", {entity.name});
    }
  }
}

void checkIds(const Scenario& scenario, CheckReport& report) {
  std::map<int, std::string> owners;
  bool inOrder = true;
  int position = 0;
  for (const Human& human : scenario.humans) {
    if (!human.listed) {
      continue;
    }
    inOrder = inOrder && human.id == ++position;
    if (human.id < 0) {
      report.error(human, "scenario.id-negative");
      continue;
    }
    const auto added = owners.emplace(human.id, human.name);
    if (!added.second) {
      report.error(human, "scenario.id-twice", {human.id, added.first->second});
    }
  }
  if (!inOrder) {
    report.warning(kScenario, "scenario.ids-not-in-order");
  }
}

void checkGoalNumbers(const Scenario& scenario, CheckReport& report) {
  std::set<int> ids;
  for (const GlobalGoal& goal : scenario.goals) {
    if (goal.id < 1) {
      report.error(goal.key, "scenario.goal-below-one", {goal.id});
    }
    if (!ids.insert(goal.id).second) {
      report.error(goal.key, "scenario.goal-twice", {goal.id});
    }
  }
  int expected = 0;
  for (const int id : ids) {
    if (id != ++expected) {
      report.warning(kScenario, "scenario.goal-missing", {expected});
      return;
    }
  }
}

template <class Traveller>
void checkGoalIds(const std::vector<int>& goals, const Scenario& scenario,
                  const Traveller& traveller, CheckReport& report) {
  std::set<int> told;
  for (const int id : goals) {
    if (scenario.goal(id) == nullptr && told.insert(id).second) {
      report.error(traveller, "scenario.goal-undefined", {id});
    }
  }
}

void checkName(const std::optional<std::string>& name, const std::vector<std::string>& known,
               const char* key, EntityId entity, const std::string& where, CheckReport& report) {
  if (name && std::find(known.begin(), known.end(), *name) == known.end()) {
    report.add(base::Severity::Error, entity, where, "scenario.unknown-word",
               {key, *name, base::nearestName(*name, known), base::join(known, ", ")});
  }
}

/// "a distance", "a number above 0", "a number from 0 to 1"
std::string expectedOf(const base::ParameterSpec& spec) {
  constexpr double kNoEnd = std::numeric_limits<double>::infinity();
  const base::Range& range = spec.range;
  if (spec.unit == "m" && range.low == 0.0 && range.high == kNoEnd) {
    return "a distance";
  }
  const std::string low = base::formatDouble(range.low);
  if (range.high < kNoEnd) {
    return "a number from " + low + " to " + base::formatDouble(range.high);
  }
  return range.low == -kNoEnd
             ? "a number"
             : "a number " + (range.above ? "above " + low : "of " + low + " or more");
}

void checkPlannerParameters(const Robot& robot, const KnownNames& names, CheckReport& report) {
  const std::string planner = robot.planner.value_or(ResolvedRobot{}.planner);
  const auto specs = names.plannerParameters.find(planner);
  if (specs == names.plannerParameters.end()) {
    return;
  }
  std::vector<std::string> known;
  for (const base::ParameterSpec& spec : specs->second) {
    known.push_back(spec.key);
  }
  for (const auto& [key, text] : robot.plannerParameters) {
    const std::string path = robot.name + ".planner_parameters." + key;
    const auto found = std::find(known.begin(), known.end(), key);
    if (found == known.end()) {
      report.add(base::Severity::Warning, robot.key, path, "planner.unknown-parameter",
                 {planner, base::nearestName(key, known)});
      continue;
    }
    const base::ParameterSpec& spec =
        specs->second[static_cast<std::size_t>(found - known.begin())];
    const std::optional<double> value = base::parseDouble(text);
    if (!value || !std::isfinite(*value) || !spec.range.contains(*value)) {
      report.add(base::Severity::Error, robot.key, path, "planner.bad-value",
                 {text, expectedOf(spec)});
    }
  }
}

void checkSource(const Area& area, const Scenario& scenario, CheckReport& report) {
  if (area.kind != AreaKind::Source) {
    return;
  }
  if (!area.like) {
    report.error(area, "source.no-like");
  } else if (scenario.human(*area.like) == nullptr) {
    report.error(area, "source.like-unknown", {*area.like});
  }
  if (!area.rate || *area.rate == 0.0) {
    report.warning(area, "source.no-rate");
  }
  if (area.until && *area.until < area.from.value_or(0.0)) {
    report.warning(area, "source.until-before-from");
  }
}

}  // namespace

void CheckReport::add(base::Severity severity, EntityId entity, const std::string& where,
                      std::string_view code, base::ProblemValues values) {
  base::Diagnostic problem = base::problem(severity, code, std::move(values), file);
  problem.entity = entity;
  diagnostics.push_back(where.empty() ? std::move(problem)
                                      : base::within(where, std::move(problem)));
}

int largestSkin(const std::string& simulator) {
  if (simulator == "Webots") {
    return 3;
  }
  return simulator.compare(0, 6, "Gazebo") == 0 ? 8 : 11;
}

void checkNames(const Scenario& scenario, CheckReport& report) {
  std::set<std::string> seen;
  collectNames(scenario.humans, seen, report);
  collectNames(scenario.robots, seen, report);
  collectNames(scenario.obstacles, seen, report);
  collectNames(scenario.doors, seen, report);
  collectNames(scenario.areas, seen, report);
  checkIds(scenario, report);
  checkGoalNumbers(scenario, report);
  if (scenario.map && mapBaseName(*scenario.map) != *scenario.map) {
    report.warning(kScenario, "scenario.map-name", {*scenario.map, mapBaseName(*scenario.map)});
  }
}

void checkReferences(const Scenario& scenario, const KnownNames& names, CheckReport& report) {
  checkName(scenario.desktop.model, names.models, "model", kScenario, {}, report);
  for (const Human& human : scenario.humans) {
    if (human.listed) {
      checkName(human.ours.model, names.models, "model", human.key, human.name, report);
      checkGoalIds(human.goals, scenario, human, report);
    }
  }
  for (const Robot& robot : scenario.robots) {
    if (robot.listed) {
      checkName(robot.type, names.robotTypes, "type", robot.key, robot.name, report);
      checkName(robot.planner, names.planners, "planner", robot.key, robot.name, report);
      checkGoalIds(robot.goal.goals, scenario, robot, report);
      checkPlannerParameters(robot, names, report);
    }
  }
  for (const Area& area : scenario.areas) {
    if (area.listed) {
      checkSource(area, scenario, report);
    }
  }
}

base::Diagnostics checkScenario(const Scenario& scenario, const Surroundings& surroundings,
                                const std::string& file, const KnownNames& names) {
  CheckReport report{file, {}};
  checkNames(scenario, report);
  checkReferences(scenario, names, report);
  checkPeople(scenario, report);
  checkShapes(scenario, report);
  if (checkCoordinates(scenario, report)) {
    checkPlaces(scenario, surroundings, report);
  }
  return std::move(report.diagnostics);
}

}  // namespace sim2d
