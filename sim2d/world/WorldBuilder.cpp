#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "sim2d/base/Problems.h"
#include "sim2d/base/Text.h"
#include "sim2d/world/Placement.h"
#include "sim2d/world/WorldInside.h"

namespace sim2d {
namespace {

constexpr double kSmallestFootprint = 1e-4;  // [m²]

bool isPositive(double value) {
  return std::isfinite(value) && value > 0.0;
}
bool isNotNegative(double value) {
  return std::isfinite(value) && value >= 0.0;
}

/// What holds for one thing, or is told.
class Checks {
 public:
  Checks(std::string who, EntityId key, base::Diagnostics& problems)
      : who_(std::move(who)), key_(key), problems_(problems) {}

  void need(bool holds, const char* code, base::ProblemValues values = {}) {
    if (!holds) {
      problems_.push_back(about(base::error(code, std::move(values)), key_, who_));
    }
  }
  /// `name` is one of the registry.
  template <class Maker>
  void needKnown(const std::string& name, const Registry<Maker>& registry, const char* code) {
    if (registry.find(name) == nullptr) {
      need(false, code, {name, base::nearestName(name, registry.names())});
    }
  }

 private:
  std::string who_;
  EntityId key_;
  base::Diagnostics& problems_;
};

void checkPerson(const WorldModel& model, const ResolvedHuman& person, EntityId key,
                 base::Diagnostics& problems) {
  Checks checks("person '" + person.name + "'", key, problems);
  checks.need(person.id >= 0, "world.bad-id");
  checks.need(isPositive(person.radius) && isPositive(person.mass), "world.bad-body");
  checks.need(isNotNegative(person.desiredSpeed) && isPositive(person.goalRadius),
              "world.bad-speed");
  checks.needKnown(person.model, model.registries->models, "world.unknown-model");
}

/// People with the same goals, reached within the same radius, share a plan.
class Plans {
 public:
  std::shared_ptr<GoalPlan> of(const std::vector<int>& goals, double radius) {
    std::shared_ptr<GoalPlan>& plan = plans_[{goals, radius}];
    if (plan == nullptr) {
      plan = std::make_shared<GoalPlan>(GoalPlan{goals, {}});
    }
    return plan;
  }

 private:
  std::map<std::pair<std::vector<int>, double>, std::shared_ptr<GoalPlan>> plans_;
};

void addPeople(const WorldSetup& setup, WorldModel& model, base::Diagnostics& problems) {
  Plans plans;
  std::vector<const Human*> listed;
  for (const Human& human : setup.scenario->humans) {
    model.nextId = std::max(model.nextId, human.id + 1);
    if (human.listed) {
      listed.push_back(&human);
    }
  }
  std::stable_sort(listed.begin(), listed.end(),
                   [](const Human* a, const Human* b) { return a->id < b->id; });
  model.people.reserve(listed.size());
  for (const Human* human : listed) {
    Person person;
    person.key = human->key;
    person.constants = resolvePerson(model, *human);
    person.plan = plans.of(human->goals, person.constants.goalRadius);
    checkPerson(model, person.constants, human->key, problems);
    if (!model.people.empty() && model.people.back().constants.id == human->id) {
      problems.push_back(
          about(base::error("world.id-taken", {human->id, model.people.back().constants.name}),
                human->key, "person '" + human->name + "'"));
    }
    model.people.push_back(std::move(person));
  }
}

bool hasParameter(const std::vector<base::ParameterSpec>& specs, const std::string& name) {
  return std::any_of(specs.begin(), specs.end(),
                     [&](const base::ParameterSpec& spec) { return spec.key == name; });
}

std::string namesOf(const std::vector<base::ParameterSpec>& specs) {
  std::vector<std::string> names;
  for (const base::ParameterSpec& spec : specs) {
    names.push_back(spec.key);
  }
  return base::join(names, ", ");
}

/// Of the models that people of this world may have.
void checkModelParameters(const WorldModel& model, base::Diagnostics& problems) {
  constexpr EntityId kScenario{base::EntityKind::Scenario, 0};
  const auto& models = model.registries->models;
  for (const auto& [name, texts] : model.environment->desktop.modelParameters) {
    const auto* const entry = models.find(name);
    if (entry == nullptr) {
      problems.push_back(
          about(base::error("world.unknown-model", {name, base::nearestName(name, models.names())}),
                kScenario, "model_parameters"));
      continue;
    }
    for (const auto& [key, text] : texts) {
      if (!hasParameter(entry->parameters, key)) {
        problems.push_back(about(
            base::error("world.unknown-model-parameter", {name, key, namesOf(entry->parameters)}),
            kScenario));
      }
    }
  }
}

void checkRobot(const Registries& registries, const ResolvedRobot& robot, EntityId key,
                base::Diagnostics& problems) {
  Checks checks("robot '" + robot.name + "'", key, problems);
  checks.needKnown(robot.type, registries.robotTypes, "world.unknown-type");
  checks.need(robot.footprint.empty()
                  ? isPositive(robot.radius)
                  : isSimple(robot.footprint) && signedArea(robot.footprint) > kSmallestFootprint,
              "world.bad-robot-body");
  checks.need(isPositive(robot.mass) && isNotNegative(robot.maxVel) && isPositive(robot.maxAcc) &&
                  isNotNegative(robot.maxOmega) && isPositive(robot.maxAlpha) &&
                  isPositive(robot.goalRadius),
              "world.bad-robot-limits");
}

base::Result<std::shared_ptr<RobotController>> makeController(const PlannerRegistry& planners,
                                                              const ResolvedRobot& robot) {
  const std::string who = "robot '" + robot.name + "'";
  const auto* const planner = planners.find(robot.planner);
  if (planner == nullptr) {
    return base::within(
        who, base::error("world.unknown-planner",
                         {robot.planner, base::nearestName(robot.planner, planners.names())}));
  }
  base::Diagnostics problems;
  for (const auto& [name, value] : robot.plannerParameters) {
    if (!hasParameter(planner->parameters, name)) {
      problems.push_back(
          base::within(who, base::error("world.unknown-parameter",
                                        {planner->name, name, namesOf(planner->parameters)})));
    }
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return planner->make(robot);
}

void addRobots(const Scenario& scenario, WorldParts& parts, base::Diagnostics& problems) {
  for (const Robot& robot : scenario.robots) {
    if (!robot.listed) {
      continue;
    }
    const int id = -1 - static_cast<int>(parts.model.robots.size());
    parts.model.robots.push_back(resolveRobot(scenario, robot, id));
    checkRobot(*parts.model.registries, parts.model.robots.back(), robot.key, problems);
    base::Result<std::shared_ptr<RobotController>> controller =
        makeController(parts.model.registries->planners, parts.model.robots.back());
    for (const base::Diagnostic& diagnostic : controller.diagnostics()) {
      problems.push_back(about(diagnostic, robot.key));
    }
    parts.controllers.push_back(controller ? *controller : nullptr);
  }
  if (!parts.model.robots.empty() && parts.model.ring.isClosed()) {
    problems.push_back(base::warning("world.robot-on-ring"));
  }
}

void addAreas(const Scenario& scenario, WorldModel& model, base::Diagnostics& problems) {
  for (const Area& area : model.environment->areas) {
    if (!area.listed) {
      continue;
    }
    model.areas.push_back(&area);
    if (area.points.size() < 3) {
      problems.push_back(
          about(base::error("world.bad-area"), area.key, "area '" + area.name + "'"));
    }
    if (area.kind != AreaKind::Source) {
      continue;
    }
    const Human* const like = area.like ? scenario.human(*area.like) : nullptr;
    if (like == nullptr) {
      problems.push_back(about(base::error("world.source-copies-nobody", {area.like}), area.key,
                               "source '" + area.name + "'"));
    } else {
      checkPerson(model, resolvePerson(model, *like), like->key, problems);
      model.patterns.emplace(like->name, *like);
    }
  }
}

void fillModel(const WorldSetup& setup, WorldParts& parts, base::Diagnostics& problems) {
  const Scenario& scenario = *setup.scenario;
  WorldModel& model = parts.model;
  model.environment = std::make_shared<const Environment>(scenario);
  model.registries = setup.registries != nullptr
                         ? setup.registries
                         : std::make_shared<const Registries>(programRegistries());
  model.compatibility = setup.compatibility;
  model.dt = scenario.desktop.dt.value_or(0.05);
  model.seed = static_cast<std::uint64_t>(scenario.desktop.seed.value_or(1));
  model.threads = std::max(1, setup.threads);
  model.exact = setup.exact;
  model.peoplePass = setup.compatibility.hunav2();
  model.obstaclePoints = scenario.desktop.obstaclePoints.value_or(ObstaclePoints::Boundary);
  if (!(model.dt >= 0.001 && model.dt <= 0.1)) {
    problems.push_back(base::error("world.bad-dt", {model.dt}));
  }
  if (scenario.desktop.wrapX.size() == 2) {
    model.ring.low = scenario.desktop.wrapX[0];
    model.ring.length = scenario.desktop.wrapX[1] - scenario.desktop.wrapX[0];
  }
  for (const Door& door : model.environment->doors) {
    if (door.listed) {
      model.doors.push_back(&door);
    }
  }
  for (const GlobalGoal& goal : scenario.goals) {
    model.globalGoals.emplace(goal.id, goal.position);
  }
  checkModelParameters(model, problems);
  addPeople(setup, model, problems);
  addRobots(scenario, parts, problems);
  addAreas(scenario, model, problems);
}

/// A model serves all people for whom it would be made alike.
class ModelsInUse {
 public:
  explicit ModelsInUse(const ModelRegistry& models) : known_(models) {}

  std::shared_ptr<const PedestrianModel> of(const ResolvedHuman& person) {
    std::shared_ptr<const PedestrianModel>& model =
        models_[{person.model, person.kind, person.goalFactor, person.obstacleFactor,
                 person.socialFactor, person.otherFactor}];
    if (model == nullptr) {
      model = known_.find(person.model)->make(person);
    }
    return model;
  }

 private:
  using Key = std::tuple<std::string, PersonKind, double, double, double, double>;
  const ModelRegistry& known_;
  std::map<Key, std::shared_ptr<const PedestrianModel>> models_;
};

}  // namespace

base::Result<std::unique_ptr<WorldParts>> buildWorld(const WorldSetup& setup) {
  base::Diagnostics problems;
  if (setup.scenario == nullptr || setup.behavior == nullptr) {
    return base::error("world.no-scenario");
  }
  auto parts = std::make_unique<WorldParts>();
  fillModel(setup, *parts, problems);
  checkPlaces(parts->model, problems);
  if (base::hasErrors(problems)) {
    return problems;
  }
  parts->surroundings = setup.surroundings != nullptr
                            ? *setup.surroundings
                            : makeSurroundings(*setup.scenario, setup.map);
  parts->navigation =
      std::make_unique<NavigationMap>(parts->surroundings.grid, parts->surroundings.obstacles,
                                      placesOf(parts->model), parts->surroundings.layers);
  fitPlaces(parts->model, *parts->navigation, problems);
  if (base::hasErrors(problems)) {
    return problems;
  }
  ModelsInUse models(parts->model.registries->models);
  for (Person& person : parts->model.people) {
    std::vector<GoalItem>& goals = person.plan->goals;
    if (goals.empty()) {
      goals = goalItems(parts->model, person.plan->written, person.constants.goalRadius);
    }
    person.model = models.of(person.constants);
  }
  leaveOutUnreachable(parts->model, *parts->navigation, problems);
  return {std::move(parts), std::move(problems)};
}

}  // namespace sim2d
