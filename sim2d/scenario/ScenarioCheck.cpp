#include "sim2d/scenario/ScenarioCheck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <type_traits>

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
        report.error(entity.key, "a person cannot have the name '" + entity.name + "'");
      }
    } else if (!isEntityName(entity.name) || blockKeys().count(entity.name) != 0) {
      report.error(entity.key, "'" + entity.name +
                                   "' cannot be a name (letters, digits and _, a letter first, no "
                                   "key of the file)");
    }
    if (!seen.insert(entity.name).second) {
      report.error(entity.key, "the name '" + entity.name + "' is there twice");
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
      report.error(human.key, human.name + ": needs an id from 0 on");
      continue;
    }
    const auto added = owners.emplace(human.id, human.name);
    if (!added.second) {
      report.error(human.key, human.name + ": id " + std::to_string(human.id) + " is that of " +
                                  added.first->second + " too");
    }
  }
  if (!inOrder) {
    report.warning(kScenario,
                   "the ids are not 1, 2, 3 … in the order of agents: HuNavSim's Isaac "
                   "wrapper cannot run that");
  }
}

void checkGoalNumbers(const Scenario& scenario, CheckReport& report) {
  std::set<int> ids;
  for (const GlobalGoal& goal : scenario.goals) {
    if (goal.id < 1) {
      report.error(goal.key, "goal " + std::to_string(goal.id) + ": goals are numbered from 1");
    }
    if (!ids.insert(goal.id).second) {
      report.error(goal.key, "goal " + std::to_string(goal.id) + " is there twice");
    }
  }
  int expected = 0;
  for (const int id : ids) {
    if (id != ++expected) {
      report.warning(kScenario, "goal " + std::to_string(expected) +
                                    " is missing in global_goals: HuNavSim stops counting there");
      return;
    }
  }
}

void checkGoalIds(const std::vector<int>& goals, const Scenario& scenario, EntityId entity,
                  const std::string& name, CheckReport& report) {
  std::set<int> told;
  for (const int id : goals) {
    if (scenario.goal(id) == nullptr && told.insert(id).second) {
      report.error(entity, name + ": goal " + std::to_string(id) + " is not defined");
    }
  }
}

void checkName(const std::optional<std::string>& name, const std::vector<std::string>& known,
               const std::string& what, EntityId entity, CheckReport& report) {
  if (!name || std::find(known.begin(), known.end(), *name) != known.end()) {
    return;
  }
  std::string all;
  for (const std::string& each : known) {
    all += (all.empty() ? "" : ", ") + each;
  }
  const auto near = base::nearestName(*name, known);
  report.error(entity, what + " '" + *name + "' is unknown (" +
                           (near ? "did you mean '" + *near + "'? " : std::string()) +
                           "known: " + all + ")");
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
    const std::string what = robot.name + ".planner_parameters." + key;
    const auto found = std::find(known.begin(), known.end(), key);
    if (found == known.end()) {
      const auto near = base::nearestName(key, known);
      report.warning(robot.key, what + ": unknown to '" + planner + "'" +
                                    (near ? " (did you mean '" + *near + "'?)" : std::string()));
      continue;
    }
    const base::ParameterSpec& spec =
        specs->second[static_cast<std::size_t>(found - known.begin())];
    const std::optional<double> value = base::parseDouble(text);
    if (!value || !std::isfinite(*value) || !spec.range.contains(*value)) {
      report.error(robot.key, what + ": '" + text + "' is not " + expectedOf(spec));
    }
  }
}

void checkSource(const Area& area, const Scenario& scenario, CheckReport& report) {
  if (area.kind != AreaKind::Source) {
    return;
  }
  if (!area.like) {
    report.error(area.key, area.name + ": a source needs 'like', the person it copies");
  } else if (scenario.human(*area.like) == nullptr) {
    report.error(area.key, area.name + ": there is no person '" + *area.like + "' to copy");
  }
  if (!area.rate || *area.rate == 0.0) {
    report.warning(area.key, area.name + ": without a 'rate' nobody arrives");
  }
  if (area.until && *area.until < area.from.value_or(0.0)) {
    report.warning(area.key, area.name + ": 'until' is before 'from', nobody arrives");
  }
}

}  // namespace

void CheckReport::error(EntityId entity, const std::string& message) {
  diagnostics.push_back({base::Severity::Error, file, 0, 0, message, entity});
}

void CheckReport::warning(EntityId entity, const std::string& message) {
  diagnostics.push_back({base::Severity::Warning, file, 0, 0, message, entity});
}

void CheckReport::info(EntityId entity, const std::string& message) {
  diagnostics.push_back({base::Severity::Info, file, 0, 0, message, entity});
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
    report.warning(kScenario, "map '" + *scenario.map + "' counts as '" +
                                  mapBaseName(*scenario.map) + "' (no folder, no extension)");
  }
}

void checkReferences(const Scenario& scenario, const KnownNames& names, CheckReport& report) {
  checkName(scenario.desktop.model, names.models, "model", kScenario, report);
  for (const Human& human : scenario.humans) {
    if (human.listed) {
      checkName(human.ours.model, names.models, human.name + ": model", human.key, report);
      checkGoalIds(human.goals, scenario, human.key, human.name, report);
    }
  }
  for (const Robot& robot : scenario.robots) {
    if (robot.listed) {
      checkName(robot.type, names.robotTypes, robot.name + ": type", robot.key, report);
      checkName(robot.planner, names.planners, robot.name + ": planner", robot.key, report);
      checkGoalIds(robot.goal.goals, scenario, robot.key, robot.name, report);
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
