#include "editor/document/Fixes.h"

#include <cmath>

#include "app/run/Bundle.h"
#include "app/run/Nav2Robots.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/document/PeopleEdits.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace editor {

namespace {

using base::Diagnostic;

/// Fixes a problem by one step with that name.
using Action = std::function<void(ScenarioDocument&, const Diagnostic&, const QString& text)>;

/// Edits the entity of the problem.
template <class T, class Change>
Action edit(Change change) {
  return [change](ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
    pushChange<T>(document, problem.entity, text, change);
  };
}

constexpr int kSearchReach = 30;  // Maximum search distance [m].
constexpr double kMargin = 0.05;  // Added to the radius, so that the position stays valid [m].

/// Rings of increasing radius around `centre`, in steps of one metre.
std::vector<Vec2> probes(const Vec2& centre) {
  std::vector<Vec2> points = {centre};
  for (int ring = 1; ring <= kSearchReach; ++ring) {
    const int count = std::max(8, static_cast<int>(std::lround(base::kPi * ring)));
    for (int i = 0; i < count; ++i) {
      points.emplace_back(centre + ring * base::directionOf(2.0 * base::kPi * i / count));
    }
  }
  return points;
}

double maxVisitorRadius(const sim2d::Scenario& scenario, int goal) {
  double radius = 0.0;
  const auto visits = [goal](const std::vector<int>& goals) {
    return std::find(goals.begin(), goals.end(), goal) != goals.end();
  };
  for (const sim2d::Human& human : scenario.humans) {
    if (human.listed && visits(human.goals)) {
      radius = std::max(radius, sim2d::resolveHuman(scenario, human, 0).radius);
    }
  }
  for (const sim2d::Robot& robot : scenario.robots) {
    if (robot.listed && visits(robot.goal.goals)) {
      radius = std::max(radius, sim2d::resolveRobot(scenario, robot, -1).radius);
    }
  }
  return radius;
}

struct BodyPlacement {
  Vec2 point = Vec2::Zero();
  double radius = 0.0;
};

BodyPlacement bodyPlacementOf(const sim2d::Scenario& scenario, const Entity& entity,
                              bool robotGoal) {
  if (const auto* human = std::get_if<sim2d::Human>(&entity)) {
    return {human->initPose.position, sim2d::resolveHuman(scenario, *human, 0).radius};
  }
  if (const auto* robot = std::get_if<sim2d::Robot>(&entity)) {
    const Vec2 at = robotGoal && robot->goal.point ? *robot->goal.point : robot->start.position;
    return {at, sim2d::resolveRobot(scenario, *robot, -1).radius};
  }
  const auto& goal = std::get<sim2d::GlobalGoal>(entity);
  return {goal.position, maxVisitorRadius(scenario, goal.id)};
}

/// The nearest position within 30 m where a body fits between walls and obstacles, which is `near`
/// itself if possible; none if there is no such position.
std::optional<Vec2> freePlace(const ScenarioDocument& document, const Vec2& near, double radius) {
  const auto around =
      document.surroundings()->of(document.scenario(), document.map(), document.mapStopFlag());
  const std::vector<Vec2> points = probes(near);
  const bool isPlane = document.map()->isEmpty();  // An open plane has no precomputed layers.
  const sim2d::NavigationMap navigation(around->grid, around->obstacles, points,
                                        isPlane ? nullptr : around->layers);
  for (const double margin : {kMargin, 0.0}) {
    for (const Vec2& point : points) {
      if (std::optional<Vec2> fit = navigation.nearestFreePosition(radius + margin, point)) {
        return fit;
      }
    }
  }
  return std::nullopt;
}

/// Moves the start of a person or robot, the goal point of a robot, or a goal (for its widest
/// visitor).
void moveToFreePlace(ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
  std::optional<Entity> value = document.entity(problem.entity);
  if (!value) {
    return;
  }
  const bool robotGoal = problem.value("place") == "goal";
  const BodyPlacement stand = bodyPlacementOf(document.scenario(), *value, robotGoal);
  const std::optional<Vec2> place = freePlace(document, stand.point, stand.radius);
  if (!place) {
    return;
  }
  if (auto* robot = std::get_if<sim2d::Robot>(&*value)) {
    (robotGoal ? robot->goal.point.emplace() : robot->start.position) = *place;
  } else {
    value = moved(*std::move(value), *place - stand.point);
  }
  pushEdit(document, {*std::move(value)}, text);
}

/// Numbers people 1, 2, 3 … in list order, those that are switched off last.
void renumberPeople(ScenarioDocument& document, const Diagnostic&, const QString& text) {
  std::vector<Entity> people;
  int next = 1;
  for (const bool listed : {true, false}) {
    for (sim2d::Human human : document.scenario().humans) {
      if (human.listed == listed) {
        human.id = next++;
        people.emplace_back(std::move(human));
      }
    }
  }
  pushEdit(document, std::move(people), text);
}

/// Numbers goals 1, 2, 3 … in the order of their numbers and updates routes.
void renumberGoals(ScenarioDocument& document, const Diagnostic&, const QString& text) {
  std::vector<sim2d::GlobalGoal> goals = document.scenario().goals;
  std::stable_sort(goals.begin(), goals.end(),
                   [](const auto& a, const auto& b) { return a.id < b.id; });
  std::map<int, int> numbers;  // A duplicate number refers to the first goal that has it.
  Draft draft(document);
  int next = 1;
  for (sim2d::GlobalGoal& goal : goals) {
    numbers.emplace(goal.id, next);
    goal.id = next++;
    draft.set(std::move(goal));
  }
  draft.forEachGoalOfRoutes([&numbers](int& goal) {
    const auto found = numbers.find(goal);
    goal = found == numbers.end() ? goal : found->second;
  });
  draft.push(text);
}

void removeGoalFromRoutes(ScenarioDocument& document, const Diagnostic& problem,
                          const QString& text) {
  const int goal = std::stoi(problem.value("goal"));
  const auto without = [goal](std::vector<int> goals) {
    goals.erase(std::remove(goals.begin(), goals.end(), goal), goals.end());
    return goals;
  };
  pushChange<sim2d::Human>(document, problem.entity, text,
                           [&](sim2d::Human& human) { setGoals(human, without(human.goals)); });
  pushChange<sim2d::Robot>(document, problem.entity, text, [&](sim2d::Robot& robot) {
    robot.goal.goals = without(robot.goal.goals);
  });
}

void assignUniqueName(ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
  std::optional<Entity> value = document.entity(problem.entity);
  if (!value) {
    return;
  }
  const std::string stem = sanitizedName(*value);
  UniqueNames names(document.scenario());
  const bool usable = stem != nameOf(*value) && !names.isTaken(stem);
  setName(*value, usable ? stem : names.name(stem));
  pushEdit(document, {*std::move(value)}, text);
}

/// Adds a robot at a free position near the people, with its goal on their other side.
void addRobot(ScenarioDocument& document, const Diagnostic&, const QString&) {
  const std::vector<sim2d::Human>& people = document.scenario().humans;
  Vec2 centre = Vec2::Zero();
  for (const sim2d::Human& human : people) {
    centre += human.initPose.position;
  }
  centre /= std::max(static_cast<int>(people.size()), 1);
  const double radius = sim2d::resolveRobot({}, {}, -1).radius;
  sim2d::Robot robot;
  const Vec2 start = centre + Vec2(-2.0, 0.0);
  const Vec2 goal = centre + Vec2(2.0, 0.0);
  robot.start.position = freePlace(document, start, radius).value_or(start);
  robot.goal.point = freePlace(document, goal, radius).value_or(goal);
  robot.start.heading = base::headingOf(*robot.goal.point - robot.start.position);
  document.setSelection({pushAdd(document, robot)});
}

void clampNumbers(sim2d::Human& human) {
  const auto clamp = [](std::optional<double>& value, double low, double high) {
    value = value ? std::optional(std::clamp(*value, low, high)) : std::nullopt;
  };
  sim2d::Behavior& behavior = human.behavior;
  if (behavior.configuration != sim2d::Configuration::Custom) {
    clamp(behavior.goalForceFactor, 2.0, 5.0);
    clamp(behavior.obstacleForceFactor, 2.0, 50.0);
    clamp(behavior.socialForceFactor, 5.0, 20.0);
    clamp(behavior.otherForceFactor, 0.0, 25.0);
  }
  if (behavior.vel) {
    behavior.vel = std::min(*behavior.vel, 1.8);
  }
}

void clampSkin(ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
  const int most = sim2d::largestSkin(document.scenario().simulator.value_or(std::string()));
  pushChange<sim2d::Human>(document, problem.entity, text, [most](sim2d::Human& human) {
    human.skin = std::clamp(human.skin.value_or(0), 0, most);
  });
}

void addReactionKeys(ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
  pushChange<sim2d::Human>(document, problem.entity, text, [&document](sim2d::Human& human) {
    addMissingReactionKeys(document.scenario(), human);
  });
}

/// Uses the suggested value of a "did you mean" problem, or else the default.
void useSuggestedValue(ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
  const std::string nearest = problem.value("nearest");
  const std::optional<std::string> word = nearest.empty() ? std::nullopt : std::optional(nearest);
  const EntityId id = problem.entity;
  pushChange<sim2d::Human>(document, id, text,
                           [&](sim2d::Human& human) { human.ours.model = word; });
  pushChange<sim2d::Robot>(document, id, text, [&](sim2d::Robot& robot) {
    (problem.value("key") == "type" ? robot.type : robot.planner) = word;
  });
  pushChange<ScenarioSettings>(document, id, text,
                               [&](ScenarioSettings& settings) { settings.desktop.model = word; });
}

/// The person that is copied by a source that names none.
std::string firstPerson(const ScenarioDocument& document, const Diagnostic&) {
  const std::vector<sim2d::Human>& people = document.scenario().humans;
  return people.empty() ? std::string() : people.front().name;
}

void copyFirstPerson(ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
  pushChange<sim2d::Area>(document, problem.entity, text,
                          [&](sim2d::Area& area) { area.like = firstPerson(document, problem); });
}

std::string plainMapName(const ScenarioDocument& document, const Diagnostic&) {
  return sim2d::mapBaseName(document.scenario().map.value_or(std::string()));
}

void writeMapName(ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
  pushChange<ScenarioSettings>(document, kSettingsId, text, [&](ScenarioSettings& settings) {
    settings.map = plainMapName(document, problem);
  });
}

void openPlane(ScenarioDocument& document, const Diagnostic&, const QString&) {
  pushOpenPlane(document);
}

void removeEntity(ScenarioDocument& document, const Diagnostic& problem, const QString&) {
  pushRemove(document, {problem.entity});
}

/// Opens the wall at a door over its full width, through walls of up to half a metre.
void openWall(ScenarioDocument& document, const Diagnostic& problem, const QString& label) {
  constexpr double kOpeningMargin = 0.3;  // Distance to each side of the door [m].
  const std::optional<Entity> entity = document.entity(problem.entity);
  const auto* door = entity ? std::get_if<sim2d::Door>(&*entity) : nullptr;
  if (door == nullptr) {
    return;
  }
  const Vec2 way = door->to - door->from;
  const Vec2 inset = std::min(kOpeningMargin / way.norm(), 0.45) * way;
  MapStroke stroke(document.map());
  stroke.paint(door->from + inset, door->to - inset, kOpeningMargin, MapPaint::Free);
  pushStroke(document, stroke, label);
}

/// A map named on the command line cannot be fixed in the scenario.
std::string ownMapFile(const ScenarioDocument&, const Diagnostic& problem) {
  return problem.value("key") == "map_file" ? "map_file" : std::string();
}

/// Copies radius or footprint of the local costmap into the scenario.
void copyNav2Footprint(ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
  pushChange<sim2d::Robot>(document, problem.entity, text, [&](sim2d::Robot& robot) {
    if (auto shaped = app::withNav2Body(robot, document.path().toStdString())) {
      robot = *std::move(shaped);
    }
  });
}

using LabelValue = std::function<std::string(const ScenarioDocument&, const Diagnostic&)>;

/// A value stored in the problem.
LabelValue problemValue(const char* key) {
  return [key](const ScenarioDocument&, const Diagnostic& problem) { return problem.value(key); };
}

struct Rule {
  std::vector<std::string_view> codes;
  const char* label;
  Action fixAction;  // None: manual fix.
  /// Value of the placeholder in the label. The rule does not apply if it is empty.
  LabelValue value = nullptr;
};

std::vector<Rule> personAndGoalRules() {
  return {
      {{"places.moved", "places.no-place"},
       QT_TRANSLATE_NOOP("QObject", "Move out of the wall"),
       moveToFreePlace},
      {{"scenario.ids-not-in-order", "scenario.id-twice", "scenario.id-negative"},
       QT_TRANSLATE_NOOP("QObject", "Renumber people"),
       renumberPeople},
      {{"scenario.goal-missing", "scenario.goal-below-one", "scenario.goal-twice"},
       QT_TRANSLATE_NOOP("QObject", "Renumber goals"),
       renumberGoals},
      {{"scenario.goal-undefined", "places.no-way"},
       QT_TRANSLATE_NOOP("QObject", "Remove goal %1 from the route"),
       removeGoalFromRoutes,
       problemValue("goal")},
      {{"places.no-way-to-point"},
       QT_TRANSLATE_NOOP("QObject", "Remove the goal"),
       edit<sim2d::Robot>([](sim2d::Robot& robot) { robot.goal.point.reset(); })},
      {{"scenario.name-twice", "scenario.bad-person-name", "person.name-is-key",
        "scenario.bad-name"},
       QT_TRANSLATE_NOOP("QObject", "Rename"),
       assignUniqueName},
      {{"person.out-of-range", "person.vel-too-high"},
       QT_TRANSLATE_NOOP("QObject", "Clamp to the range"),
       edit<sim2d::Human>(clampNumbers)},
      {{"person.skin-unknown"}, QT_TRANSLATE_NOOP("QObject", "Clamp to the range"), clampSkin},
      {{"person.behavior-incomplete"},
       QT_TRANSLATE_NOOP("QObject", "Add these values"),
       addReactionKeys},
      {{"person.no-init-pose"},
       QT_TRANSLATE_NOOP("QObject", "Set the start to 0, 0"),
       edit<sim2d::Human>([](sim2d::Human& human) { human.hasInitPose = true; })},
      {{"person.wait-count"},
       QT_TRANSLATE_NOOP("QObject", "Set one wait per goal"),
       edit<sim2d::Human>(
           [](sim2d::Human& human) { human.ours.wait.resize(human.goals.size(), 0.0); })},
      {{"person.no-goals"}, QT_TRANSLATE_NOOP("QObject", "Assign goals…"), {}},
  };
}

/// In the order in which they are tried.
std::vector<Rule> rules() {
  std::vector<Rule> all = personAndGoalRules();
  std::vector<Rule> others = {
      {{"scenario.unknown-word"},
       QT_TRANSLATE_NOOP("QObject", "Use '%1'"),
       useSuggestedValue,
       problemValue("nearest")},
      {{"scenario.unknown-word"},
       QT_TRANSLATE_NOOP("QObject", "Use the default"),
       useSuggestedValue},
      {{"source.no-like", "source.like-unknown"},
       QT_TRANSLATE_NOOP("QObject", "Copy %1"),
       copyFirstPerson,
       firstPerson},
      {{"source.no-rate"},
       QT_TRANSLATE_NOOP("QObject", "Set rate to 0.1 /s"),
       edit<sim2d::Area>([](sim2d::Area& area) { area.rate = 0.1; })},
      {{"source.until-before-from"},
       QT_TRANSLATE_NOOP("QObject", "Swap the times"),
       edit<sim2d::Area>([](sim2d::Area& area) { std::swap(area.from, area.until); })},
      {{"shape.door-without-length"}, QT_TRANSLATE_NOOP("QObject", "Remove"), removeEntity},
      {{"places.door-in-wall"}, QT_TRANSLATE_NOOP("QObject", "Open the wall"), openWall},
      {{"scenario.map-name"},
       QT_TRANSLATE_NOOP("QObject", "Set to '%1'"),
       writeMapName,
       plainMapName},
      {{"map.not-found", "map.not-named"},
       QT_TRANSLATE_NOOP("QObject", "Use open plane"),
       openPlane},
      {{"map.not-there", "map.is-folder"},
       QT_TRANSLATE_NOOP("QObject", "Use open plane"),
       openPlane,
       ownMapFile},
      {{"scenario.no-robot"}, QT_TRANSLATE_NOOP("QObject", "Add a robot"), addRobot},
      {{"nav2.body-differs"},
       QT_TRANSLATE_NOOP("QObject", "Use the body in the Nav2 file"),
       copyNav2Footprint},
  };
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

}  // namespace

std::optional<Fix> fixFor(const ScenarioDocument& document, const base::Diagnostic& problem) {
  if (!problem.entity || !document.contains(problem.entity)) {
    return std::nullopt;
  }
  static const std::vector<Rule> kRules = rules();
  for (const Rule& rule : kRules) {
    const bool isMeant = std::count(rule.codes.begin(), rule.codes.end(), problem.code) > 0;
    const std::string value = isMeant && rule.value ? rule.value(document, problem) : std::string();
    if (!isMeant || (rule.value && value.empty())) {
      continue;
    }
    QString label = QObject::tr(rule.label);
    label.replace(QStringLiteral("%1"), QString::fromStdString(value));
    Fix fix{label, {}};
    if (rule.fixAction) {
      fix.apply = [fixAction = rule.fixAction, problem, label](ScenarioDocument& edited) {
        fixAction(edited, problem, label);
      };
    }
    return fix;
  }
  return std::nullopt;
}

void applyToAll(ScenarioDocument& document, const base::Diagnostics& problems,
                const QString& label) {
  document.undoStack().beginMacro(label);
  for (const base::Diagnostic& problem : problems) {
    const std::optional<Fix> fix = fixFor(document, problem);
    if (fix && fix->label == label && fix->apply) {
      fix->apply(document);
    }
  }
  document.undoStack().endMacro();
}

base::Diagnostics adviceFor(const sim2d::Scenario& scenario) {
  const auto listed = [](const auto& each) { return each.listed; };
  const bool people = std::any_of(scenario.humans.begin(), scenario.humans.end(), listed);
  if (!people || std::any_of(scenario.robots.begin(), scenario.robots.end(), listed)) {
    return {};
  }
  base::Diagnostic advice = base::problem(base::Severity::Info, "scenario.no-robot");
  advice.entity = {EntityKind::Scenario, 0};
  return {std::move(advice)};
}

}  // namespace editor
