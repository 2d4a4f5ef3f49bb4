#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/map/DistanceField.h"
#include "sim2d/scenario/Variation.h"
#include "sim2d/world/World.h"

namespace sim2d {
namespace {

constexpr double kSmallestFootprint = 1e-4;  // [m²]

bool isPositive(double value) {
  return std::isfinite(value) && value > 0.0;
}
bool isNotNegative(double value) {
  return std::isfinite(value) && value >= 0.0;
}

/// Reports an error and returns null if there is no such entry.
template <class Maker>
auto requireEntry(const base::Registry<Maker>& registry, const std::string& name, const char* code,
                  EntityProblems& found) {
  const auto* const entry = registry.find(name);
  if (entry == nullptr) {
    found.add(base::error(code, {name, base::nearestName(name, registry.names())}));
  }
  return entry;
}

/// Reports an error and returns false if the entry has no such parameter.
template <class Entry>
bool requireParameter(const Entry& entry, const std::string& key, const char* code,
                      EntityProblems& found) {
  std::vector<std::string> keys;
  for (const base::ParameterSpec& spec : entry.parameters) {
    keys.push_back(spec.key);
  }
  const bool isThere = std::find(keys.begin(), keys.end(), key) != keys.end();
  found.need(isThere, code, {entry.name, key, base::join(keys, ", ")});
  return isThere;
}

void checkPerson(const WorldModel& model, const ResolvedHuman& person, EntityId key,
                 base::Diagnostics& problems) {
  EntityProblems found(key, "person '" + person.name + "'", problems);
  found.need(person.id >= 0, "world.bad-id");
  found.need(isPositive(person.radius) && isPositive(person.mass), "world.bad-body");
  found.need(isNotNegative(person.desiredSpeed) && isPositive(person.goalRadius),
             "world.bad-speed");
  requireEntry(model.registries->models, person.model, "world.unknown-model", found);
}

void addPeople(const WorldSetup& setup, WorldModel& model, base::Diagnostics& problems) {
  // People with the same goals and goal radius share a plan.
  std::map<std::pair<std::vector<int>, double>, std::shared_ptr<GoalPlan>> plans;
  std::vector<const Human*> listed;
  for (const Human& human : setup.scenario->humans) {
    model.lastId = std::max(model.lastId, human.id);
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
    const FirstGoal first =
        firstGoalOf(setup.scenario->desktop.variation, *human, static_cast<long long>(model.seed));
    person.constants = resolvePerson(model, *human);
    person.constants.wait = first.wait;
    std::shared_ptr<GoalPlan>& plan = plans[{first.goals, person.constants.goalRadius}];
    if (plan == nullptr) {
      plan = std::make_shared<GoalPlan>(GoalPlan{first.goals, {}});
    }
    person.plan = plan;
    checkPerson(model, person.constants, human->key, problems);
    if (!model.people.empty() && model.people.back().constants.id == human->id) {
      EntityProblems(human->key, "person '" + human->name + "'", problems)
          .add(base::error("world.id-taken", {human->id, model.people.back().constants.name}));
    }
    model.people.push_back(std::move(person));
  }
}

/// Checks the parameters of all models that people of this world may have.
void checkModelParameters(const WorldModel& model, base::Diagnostics& problems) {
  constexpr EntityId kScenario{base::EntityKind::Scenario, 0};
  EntityProblems ofModels(kScenario, "model_parameters", problems);
  EntityProblems ofKeys(kScenario, {}, problems);
  for (const auto& [name, texts] : model.environment->desktop.modelParameters) {
    const auto* const entry =
        requireEntry(model.registries->models, name, "world.unknown-model", ofModels);
    for (auto text = texts.begin(); entry != nullptr && text != texts.end(); ++text) {
      requireParameter(*entry, text->first, "world.unknown-model-parameter", ofKeys);
    }
  }
}

void checkRobot(const Registries& registries, const ResolvedRobot& robot, EntityProblems& found) {
  requireEntry(registries.robotTypes, robot.type, "world.unknown-type", found);
  found.need(robot.footprint.empty()
                 ? isPositive(robot.radius)
                 : isSimple(robot.footprint) && signedArea(robot.footprint) > kSmallestFootprint,
             "world.bad-robot-body");
  found.need(isPositive(robot.mass) && isNotNegative(robot.maxVel) && isPositive(robot.maxAcc) &&
                 isNotNegative(robot.maxOmega) && isPositive(robot.maxAlpha) &&
                 isPositive(robot.goalRadius),
             "world.bad-robot-limits");
  found.need(robot.kinematics != Kinematics::Ackermann || isPositive(robot.turningRadius),
             "world.no-turning-radius");
  found.need(robot.lidar.beams == 0 || areValidParameters(robot.lidar), "world.bad-lidar");
}

/// Warns about keys without effect.
void warnUnusedSensorKeys(const Robot& robot, const ResolvedRobot& resolved,
                          EntityProblems& found) {
  if (resolved.lidar.beams == 0 && !robot.lidar.beams && !(robot.lidar == LidarSettings{})) {
    found.add(base::warning("world.no-lidar", {resolved.type}));
  }
  DetectorSettings others = robot.detector;
  others.kind.reset();
  if (resolved.detectorKind == DetectorKind::GroundTruth && !(others == DetectorSettings{})) {
    found.add(base::warning("world.sees-everybody"));
  }
}

/// Distributes planner parameters to numbers and texts, by type.
void setPlannerParameters(const ResolvedRobot& robot, const std::vector<base::ParameterSpec>& specs,
                          PlannerSetup& to) {
  const auto isText = [&](const std::string& key) {
    return std::any_of(specs.begin(), specs.end(), [&](const base::ParameterSpec& spec) {
      return spec.key == key && spec.type == base::ParameterType::Text;
    });
  };
  for (const auto& [key, value] : robot.plannerParameters) {
    if (!isText(key)) {
      to.parameters.emplace_back(key, value);
    }
  }
  for (const auto& [key, text] : robot.plannerTexts) {
    if (isText(key)) {
      to.texts.emplace_back(key, text);
    }
  }
}

std::vector<DockPose> docksOf(const WorldModel& model) {
  std::vector<DockPose> docks;
  docks.reserve(model.docks.size());
  for (const Dock* const dock : model.docks) {
    docks.push_back({dock->name, dock->pose, dock->kind == DockKind::Charging});
  }
  return docks;
}

/// Listed people and robots, with their ids.
std::vector<std::pair<std::string, int>> namesOf(const Scenario& scenario) {
  std::vector<std::pair<std::string, int>> names;
  forEachListed(scenario.humans,
                [&](const Human& human) { names.emplace_back(human.name, human.id); });
  int id = 0;
  forEachListed(scenario.robots, [&](const Robot& robot) { names.emplace_back(robot.name, --id); });
  return names;
}

/// Null if there is a problem.
std::shared_ptr<Planner> makePlanner(const WorldSetup& world, const WorldModel& model,
                                     const ResolvedRobot& robot, EntityId key,
                                     EntityProblems& found, base::Diagnostics& problems) {
  const auto* const entry =
      requireEntry(model.registries->planners, robot.planner, "world.unknown-planner", found);
  bool isFine = entry != nullptr;
  for (std::size_t i = 0; entry != nullptr && i < robot.plannerTexts.size(); ++i) {
    isFine &=
        requireParameter(*entry, robot.plannerTexts[i].first, "world.unknown-parameter", found);
  }
  if (!isFine) {
    return nullptr;
  }
  PlannerSetup setup;
  setup.robot = robot.name;
  setup.body = bodyOf(robot);
  setup.hasLidar = robot.lidar.beams > 0;
  setPlannerParameters(robot, entry->parameters, setup);
  setup.nav2 = {robot.nav2Params, robot.nav2Tree, robot.nav2Distro, robot.nav2Values,
                robot.nav2Topics};
  setup.goalRadius = robot.goalRadius;
  setup.dt = model.dt;
  setup.seed = model.seed;
  setup.robotId = robot.id;
  setup.command = robot.command;
  setup.folder = world.folder;
  setup.code = world.code;
  setup.stop = world.stop;
  setup.docks = docksOf(model);
  setup.names = namesOf(*world.scenario);
  const base::Result<std::shared_ptr<Planner>> planner = entry->make(setup);
  for (const base::Diagnostic& diagnostic : planner.diagnostics()) {
    EntityProblems(key, {}, problems).add(diagnostic);
  }
  return planner ? *planner : nullptr;
}

void addRobots(const WorldSetup& setup, WorldParts& parts, base::Diagnostics& problems) {
  const Scenario& scenario = *setup.scenario;
  const Registries& registries = *parts.model.registries;
  for (const Robot& robot : scenario.robots) {
    if (!robot.listed) {
      continue;
    }
    const int id = -1 - static_cast<int>(parts.model.robots.size());
    const ResolvedRobot& resolved =
        parts.model.robots.emplace_back(resolveRobot(scenario, robot, id));
    parts.model.robotKeys.push_back(robot.key);
    EntityProblems found(robot.key, "robot '" + resolved.name + "'", problems);
    checkRobot(registries, resolved, found);
    warnUnusedSensorKeys(robot, resolved, found);
    parts.planners.push_back(makePlanner(setup, parts.model, resolved, robot.key, found, problems));
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
    EntityProblems(area.key, "area '" + area.name + "'", problems)
        .need(area.points.size() >= 3, "world.bad-area");
    if (area.kind == AreaKind::Speed) {
      model.speedZones.push_back(&area);
    }
    if (area.kind != AreaKind::Source) {
      continue;
    }
    const Human* const like = area.like ? scenario.human(*area.like) : nullptr;
    EntityProblems(area.key, "source '" + area.name + "'", problems)
        .need(like != nullptr, "world.source-copies-nobody", {area.like});
    if (like != nullptr) {
      checkPerson(model, resolvePerson(model, *like), like->key, problems);
      model.sourceTemplates.emplace(like->name, *like);
    }
  }
}

void fillModel(const WorldSetup& setup, WorldParts& parts, base::Diagnostics& problems) {
  const Scenario& scenario = *setup.scenario;
  WorldModel& model = parts.model;
  model.environment = std::make_shared<const Environment>(scenario);
  model.registries = setup.registries != nullptr
                         ? setup.registries
                         : std::make_shared<const Registries>(builtinRegistries());
  model.compatibility = setup.compatibility;
  model.dt = scenario.desktop.dt.value_or(0.05);
  model.seed = static_cast<std::uint64_t>(scenario.desktop.seed.value_or(1));
  model.drawSeed = model.seed;
  model.threads = std::max(1, setup.threads);
  model.exact = setup.exact;
  model.peoplePass = setup.compatibility.hunav2();
  model.obstaclePoints = scenario.desktop.obstaclePoints.value_or(ObstaclePoints::Boundary);
  model.stuckAfter = scenario.desktop.stuckAfter.value_or(0.0);
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
  forEachListed(model.environment->docks, [&](const Dock& dock) { model.docks.push_back(&dock); });
  for (const GlobalGoal& goal : scenario.goals) {
    model.globalGoals.emplace(goal.id, goal.position);
  }
  checkModelParameters(model, problems);
  addPeople(setup, model, problems);
  addRobots(setup, parts, problems);
  addAreas(scenario, model, problems);
}

/// People for whom the model would be created identically share it.
void assignModels(WorldModel& model) {
  using Key = std::tuple<std::string, PersonKind, double, double, double, double, double>;
  std::map<Key, std::shared_ptr<const PedestrianModel>> made;
  for (Person& person : model.people) {
    const ResolvedHuman& of = person.constants;
    std::shared_ptr<const PedestrianModel>& same =
        made[{of.model, of.kind, of.goalFactor, of.obstacleFactor, of.socialFactor, of.otherFactor,
              of.reactionTime}];
    if (same == nullptr) {
      same = model.registries->models.find(of.model)->make(of);
    }
    person.model = same;
  }
}

/// Passes the map, including drawn obstacles and open doors, to planners that need it.
void passMaps(const WorldSetup& setup, WorldParts& parts, base::Diagnostics& problems) {
  std::optional<OccupancyGrid> map;
  for (std::size_t i = 0; i < parts.planners.size(); ++i) {
    if (!parts.planners[i]->needsMap()) {
      continue;
    }
    const Surroundings& around = parts.surroundings;
    const bool isDrawnOn = around.firstObstaclePart < around.firstDoorPart;
    if (!map && (isDrawnOn || around.grid.isEmpty())) {
      Obstacles standing = around.obstacles;
      for (int part = around.firstDoorPart; part < standing.partCount(); ++part) {
        standing.setEnabled(part, false);
      }
      map = DistanceField(around.grid, standing, placementPoints(parts.model),
                          DistanceField::kMaxCells, setup.stop)
                .grid();
    } else if (!map) {
      map = around.grid;
    }
    for (const base::Diagnostic& told : parts.planners[i]->takeMap(*map)) {
      EntityProblems(parts.model.robotKeys[i], {}, problems).add(told);
    }
  }
}

}  // namespace

base::Result<std::unique_ptr<WorldParts>> buildWorld(const WorldSetup& setup) {
  base::Diagnostics problems;
  if (setup.scenario == nullptr || setup.behavior == nullptr) {
    return base::error("world.no-scenario");
  }
  auto parts = std::make_unique<WorldParts>();
  fillModel(setup, *parts, problems);
  checkPlacement(parts->model, problems);
  if (base::hasErrors(problems)) {
    return problems;
  }
  parts->surroundings = setup.surroundings != nullptr
                            ? *setup.surroundings
                            : makeSurroundings(*setup.scenario, setup.map);
  parts->navigation =
      std::make_unique<NavigationMap>(parts->surroundings.grid, parts->surroundings.obstacles,
                                      placementPoints(parts->model), parts->surroundings.layers);
  fitPlacement(parts->model, *parts->navigation, problems);
  passMaps(setup, *parts, problems);
  varyStarts(*setup.scenario, *parts->navigation, parts->model);
  if (base::hasErrors(problems)) {
    return problems;
  }
  for (Person& person : parts->model.people) {
    std::vector<GoalItem>& goals = person.plan->goals;
    if (goals.empty()) {
      goals = goalItemsOf(parts->model, person.plan->written, person.constants.goalRadius);
    }
  }
  assignModels(parts->model);
  removeUnreachableGoals(parts->model, *parts->navigation, problems);
  return {std::move(parts), std::move(problems)};
}

}  // namespace sim2d
