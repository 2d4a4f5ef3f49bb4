#include "sim2d/scenario/ScenarioCheck.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <type_traits>

#include "sim2d/base/Text.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/ScenarioYaml.h"

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
    } else if (!isEntityName(entity.name) || desktopKeys().count(entity.name) != 0) {
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
  forEachListed(scenario.humans, [&](const Human& human) {
    inOrder = inOrder && human.id == ++position;
    const auto [owner, isFirst] = owners.emplace(human.id, human.name);
    if (human.id < 0) {
      report.error(human, "scenario.id-negative");
    } else if (!isFirst) {
      report.error(human, "scenario.id-twice", {human.id, owner->second});
    }
  });
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

void checkGoalIds(const std::vector<int>& goals, const Scenario& scenario,
                  const NamedEntity& traveller, CheckReport& report) {
  std::set<int> told;
  for (const int id : goals) {
    if (scenario.goal(id) == nullptr && told.insert(id).second) {
      report.error(traveller, "scenario.goal-undefined", {id});
    }
  }
}

void checkName(const std::optional<std::string>& name, const std::vector<std::string>& known,
               const char* key, const Subject& subject, CheckReport& report) {
  if (name && std::find(known.begin(), known.end(), *name) == known.end()) {
    report.error(subject, "scenario.unknown-word",
                 {key, *name, base::nearestName(*name, known), base::join(known, ", ")});
  }
}

/// "a number", "a number above 0", "a number from 0 to 100 m"
std::string expectedOf(const ParameterSpec& spec) {
  const base::Range& range = spec.range;
  const std::string unit = spec.unit.empty() ? "" : " " + spec.unit;
  const std::string low = base::formatDouble(range.low);
  if (std::isfinite(range.high)) {
    return std::string("a number ") + (range.excludesLow ? "above " : "from ") + low + " to " +
           base::formatDouble(range.high) + unit;
  }
  if (std::isinf(range.low)) {
    return "a number";
  }
  return "a number " +
         (range.excludesLow ? "above " + low + unit : "of " + low + unit + " or more");
}

/// `owner`: name of the planner or model.
void checkParameters(const ParameterTexts& given, const std::string& owner,
                     const std::map<std::string, std::vector<ParameterSpec>>& all,
                     const Subject& subject, CheckReport& report) {
  const auto specs = all.find(owner);
  if (specs == all.end()) {
    return;
  }
  for (const auto& [key, text] : given) {
    const Subject parameter(subject.entity, subject.where + "." + key);
    std::vector<std::string> known;
    const ParameterSpec* found = nullptr;
    for (const ParameterSpec& spec : specs->second) {
      known.push_back(spec.key);
      found = spec.key == key ? &spec : found;
    }
    const std::optional<double> value = base::parseDouble(text);
    if (found == nullptr) {
      report.error(parameter, "planner.unknown-parameter", {owner, base::nearestName(key, known)});
    } else if (found->type == ParameterType::Text) {
      continue;  // any scalar is valid
    } else if (!value || !std::isfinite(*value) || !found->range.contains(*value)) {
      report.error(parameter, "planner.bad-value", {text, expectedOf(*found)});
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

/// A spawned agent gets the id after the highest one in use.
void checkIdsLeft(const Scenario& scenario, CheckReport& report) {
  int greatest = 0;
  for (const Human& human : scenario.humans) {
    greatest = std::max(greatest, human.id);
  }
  std::int64_t left = std::int64_t{std::numeric_limits<int>::max()} - greatest;
  forEachListed(scenario.areas, [&](const Area& area) {
    left -= area.kind == AreaKind::Source ? area.count.value_or(1) : 0;
    if (area.kind == AreaKind::Source && left < 0) {
      report.warning(area, "source.no-ids", {std::to_string(greatest)});
    }
  });
}

struct Limits {
  const char* key;
  std::optional<double> value;
  double low, high;
};

void checkLimits(const Human& human, CheckReport& report) {
  const Behavior& behavior = human.behavior;
  const std::vector<Limits> factors = {
      {"goal_force_factor", behavior.goalForceFactor, 2.0, 5.0},
      {"obstacle_force_factor", behavior.obstacleForceFactor, 2.0, 50.0},
      {"social_force_factor", behavior.socialForceFactor, 5.0, 20.0},
      {"other_force_factor", behavior.otherForceFactor, 0.0, 25.0},
  };
  const bool custom = behavior.configuration == Configuration::Custom;
  for (const Limits& limits : factors) {
    if (!custom && limits.value && (*limits.value < limits.low || *limits.value > limits.high)) {
      report.warning(human, "person.out-of-range",
                     {limits.key, *limits.value, limits.low, limits.high});
    }
  }
  if (behavior.vel && *behavior.vel > 1.8) {
    report.warning(human, "person.vel-too-high", {*behavior.vel});
  }
}

/// Warns about keys that the reaction needs and the file omits, with the values used.
void checkReaction(const Scenario& scenario, const Human& human, CheckReport& report) {
  const Behavior& behavior = human.behavior;
  if (!behavior.type || !reactsToRobot(*behavior.type)) {
    return;
  }
  const ResolvedHuman counts = resolveHuman(scenario, human, 0);
  const bool drawn = isDrawn(counts.configuration);
  std::vector<std::string> missing;
  for (const std::string_view key : reactionKeys(counts.behavior)) {
    const Field<Behavior>& field = *fieldOf<Behavior>(key);
    const ParameterValue used = field.resolved(counts, field.spec);
    const double* number = std::get_if<double>(&used);
    if (field.value(behavior) == ParameterValue() && (number == nullptr || !drawn)) {
      missing.push_back(field.spec.key + " " +
                        (number == nullptr ? "false" : base::formatDouble(*number)));
    }
  }
  if (!missing.empty()) {
    report.warning(human, "person.behavior-incomplete", {base::join(missing, ", ")});
  }
}

void checkPerson(const Scenario& scenario, const Human& human, CheckReport& report) {
  checkLimits(human, report);
  checkReaction(scenario, human, report);
  const int most = largestSkin(scenario.simulator.value_or(""));
  if (human.skin && *human.skin != -1 && (*human.skin < 0 || *human.skin > most)) {
    report.warning(human, "person.skin-unknown",
                   {*human.skin, std::clamp(*human.skin, 0, most), most,
                    scenario.simulator.value_or("no simulator named")});
  }
  if (!human.hasInitPose) {
    report.warning(human, "person.no-init-pose");
  }
  if (human.goals.empty()) {
    report.warning(human, "person.no-goals");
  }
  if (!human.ours.wait.empty() && human.ours.wait.size() != human.goals.size()) {
    report.error(human, "person.wait-count", {human.goals.size(), human.ours.wait.size()});
  }
  if (!(human.ours == PersonExtension{}) && desktopKeys().count(human.name) != 0) {
    report.error(human.key, "person.name-is-key", {human.name});
  }
}

void checkNames(const Scenario& scenario, CheckReport& report) {
  std::set<std::string> seen;
  collectNames(scenario.humans, seen, report);
  forEachEntityList(scenario, [&](const char* /*key*/, base::EntityKind /*kind*/,
                                  const auto& list) { collectNames(list, seen, report); });
  checkIds(scenario, report);
  checkGoalNumbers(scenario, report);
  if (scenario.map && mapBaseName(*scenario.map) != *scenario.map) {
    report.warning(kScenario, "scenario.map-name", {*scenario.map, mapBaseName(*scenario.map)});
  }
}

void checkReferences(const Scenario& scenario, const KnownNames& names, CheckReport& report) {
  checkName(scenario.desktop.model, names.models, "model", kScenario, report);
  for (const auto& [model, parameters] : scenario.desktop.modelParameters) {
    checkName(model, names.models, "model", {kScenario, "model_parameters"}, report);
    checkParameters(parameters, model, names.modelParameters,
                    {kScenario, "model_parameters." + model}, report);
  }
  forEachListed(scenario.humans, [&](const Human& human) {
    checkName(human.ours.model, names.models, "model", human, report);
    checkGoalIds(human.goals, scenario, human, report);
  });
  forEachListed(scenario.robots, [&](const Robot& robot) {
    checkName(robot.type, names.robotTypes, "type", robot, report);
    checkName(robot.planner, names.planners, "planner", robot, report);
    checkGoalIds(robot.goal.goals, scenario, robot, report);
    checkParameters(robot.plannerParameters, robot.planner.value_or(ResolvedRobot{}.planner),
                    names.plannerParameters, {robot.key, robot.name + ".planner_parameters"},
                    report);
    if (robot.command && robot.planner.value_or(ResolvedRobot{}.planner) != kExternalPlanner) {
      report.warning({robot.key, robot.name + ".command"}, "planner.command-unused",
                     {robot.planner.value_or(ResolvedRobot{}.planner)});
    }
  });
  forEachListed(scenario.areas, [&](const Area& area) { checkSource(area, scenario, report); });
  checkIdsLeft(scenario, report);
}

void checkPeople(const Scenario& scenario, CheckReport& report) {
  forEachListed(scenario.humans, [&](const Human& human) { checkPerson(scenario, human, report); });
  const auto hasListed = [](const auto& all) {
    return std::any_of(all.begin(), all.end(), [](const auto& each) { return each.listed; });
  };
  const bool hasSource =
      std::any_of(scenario.areas.begin(), scenario.areas.end(),
                  [](const Area& area) { return area.listed && area.kind == AreaKind::Source; });
  if (!hasListed(scenario.humans) && !hasListed(scenario.robots) && !hasSource) {
    report.warning(kScenario, "scenario.nobody");
  }
}

}  // namespace

void CheckReport::add(base::Severity severity, const Subject& subject, std::string_view code,
                      base::ProblemValues values) {
  base::Diagnostic problem = base::problem(severity, code, std::move(values), file);
  problem.entity = subject.entity;
  diagnostics.push_back(subject.where.empty()
                            ? std::move(problem)
                            : base::withContext(subject.where, std::move(problem)));
}

int largestSkin(const std::string& simulator) {
  if (simulator == "Webots") {
    return 3;
  }
  return base::startsWith(simulator, "Gazebo") ? 8 : 11;
}

base::Diagnostics checkScenario(const Scenario& scenario, const Surroundings& surroundings,
                                const std::string& file, const KnownNames& names) {
  CheckReport report{file, {}};
  checkNames(scenario, report);
  checkReferences(scenario, names, report);
  checkPeople(scenario, report);
  checkCard(scenario, report);
  checkPlausibility(scenario, report);
  checkShapes(scenario, report);
  if (checkCoordinates(scenario, report)) {
    checkPlaces(scenario, surroundings, report);
  }
  return std::move(report.diagnostics);
}

}  // namespace sim2d
