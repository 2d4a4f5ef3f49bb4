#include "editor/document/Fixes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string_view>

#include "app/run/Bundle.h"
#include "app/run/Nav2Body.h"
#include "editor/document/BehaviorValues.h"
#include "editor/document/EditCommands.h"
#include "editor/document/FreeNames.h"
#include "editor/document/MapEdit.h"
#include "editor/document/RoutePlan.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace editor {

namespace {

using base::Diagnostic;

/// Mends a problem by one step of that name.
using Action = std::function<void(ScenarioDocument&, const Diagnostic&, const QString& text)>;

/// Changes what the problem is about.
template <class T, class Change>
Action edit(Change change) {
  return [change](ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
    pushChange<T>(document, problem.entity, text, change);
  };
}

constexpr int kFarthest = 30;     // [m]
constexpr double kMargin = 0.05;  // beside the radius, so that the place holds [m]

/// Rings of growing size round `centre`, in steps of a metre.
std::vector<Vec2> probes(const Vec2& centre) {
  std::vector<Vec2> points = {centre};
  for (int ring = 1; ring <= kFarthest; ++ring) {
    const int count = std::max(8, static_cast<int>(std::lround(base::kPi * ring)));
    for (int i = 0; i < count; ++i) {
      points.emplace_back(centre + ring * base::directionOf(2.0 * base::kPi * i / count));
    }
  }
  return points;
}

double widestVisitor(const sim2d::Scenario& scenario, int goal) {
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

struct Stand {
  Vec2 point = Vec2::Zero();
  double radius = 0.0;
};

Stand standOf(const sim2d::Scenario& scenario, const Entity& entity, bool robotGoal) {
  if (const auto* human = std::get_if<sim2d::Human>(&entity)) {
    return {human->initPose.position, sim2d::resolveHuman(scenario, *human, 0).radius};
  }
  if (const auto* robot = std::get_if<sim2d::Robot>(&entity)) {
    const Vec2 at = robotGoal && robot->goal.point ? *robot->goal.point : robot->start.position;
    return {at, sim2d::resolveRobot(scenario, *robot, -1).radius};
  }
  const auto& goal = std::get<sim2d::GlobalGoal>(entity);
  return {goal.position, widestVisitor(scenario, goal.id)};
}

/// The nearest place within 30 m where a body fits between walls and obstacles, `near` itself when
/// it does; nothing when there is none.
std::optional<Vec2> freePlace(const ScenarioDocument& document, const Vec2& near, double radius) {
  const auto around =
      document.surroundings()->of(document.scenario(), document.map(), document.mapWork());
  const std::vector<Vec2> points = probes(near);
  const bool isPlane = document.map()->isEmpty();  // layers are of places there
  const sim2d::NavigationMap navigation(around->grid, around->obstacles, points,
                                        isPlane ? nullptr : around->layers);
  for (const double margin : {kMargin, 0.0}) {
    for (const Vec2& point : points) {
      if (std::optional<Vec2> fit = navigation.nearestFit(radius + margin, point)) {
        return fit;
      }
    }
  }
  return std::nullopt;
}

/// A person's or robot's start, a robot's own goal point, or a goal (for the widest who visit it).
void moveToFreePlace(ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
  std::optional<Entity> value = document.entity(problem.entity);
  if (!value) {
    return;
  }
  const bool robotGoal = problem.value("place") == "goal";
  const Stand stand = standOf(document.scenario(), *value, robotGoal);
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

/// 1, 2, 3 … in the order of the list, those that are switched off last.
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

/// 1, 2, 3 … in the order of the numbers; routes follow.
void renumberGoals(ScenarioDocument& document, const Diagnostic&, const QString& text) {
  std::vector<sim2d::GlobalGoal> goals = document.scenario().goals;
  std::stable_sort(goals.begin(), goals.end(),
                   [](const auto& a, const auto& b) { return a.id < b.id; });
  std::map<int, int> numbers;  // a number that is there twice stays with the first
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

void leaveOutGoal(ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
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

void giveFreeName(ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
  std::optional<Entity> value = document.entity(problem.entity);
  if (!value) {
    return;
  }
  const std::string stem = allowedName(*value);
  FreeNames names(document.scenario());
  const bool usable = stem != nameOf(*value) && !names.isTaken(stem);
  setName(*value, usable ? stem : names.name(stem));
  pushEdit(document, {*std::move(value)}, text);
}

/// In a free place near the people, its goal on their other side.
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

void writeWholeReaction(ScenarioDocument& document, const Diagnostic& problem,
                        const QString& text) {
  pushChange<sim2d::Human>(document, problem.entity, text, [&document](sim2d::Human& human) {
    completeReaction(document.scenario(), human);
  });
}

/// "did you mean": what was meant, else the default.
void useKnownWord(ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
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

/// The one who is copied by a source that names nobody.
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

void removeIt(ScenarioDocument& document, const Diagnostic& problem, const QString&) {
  pushRemove(document, {problem.entity});
}

/// A hole in the map as wide as the door, through walls of up to half a metre.
void openWall(ScenarioDocument& document, const Diagnostic& problem, const QString& words) {
  constexpr double kReach = 0.3;  // [m] to each side of the door
  const std::optional<Entity> entity = document.entity(problem.entity);
  const auto* door = entity ? std::get_if<sim2d::Door>(&*entity) : nullptr;
  if (door == nullptr) {
    return;
  }
  const Vec2 way = door->to - door->from;
  const Vec2 inset = std::min(kReach / way.norm(), 0.45) * way;
  MapStroke stroke(document.map());
  stroke.paint(door->from + inset, door->to - inset, kReach, MapPaint::Free);
  pushStroke(document, stroke, words);
}

/// What the command line names, the scenario cannot mend.
std::string ownMapFile(const ScenarioDocument&, const Diagnostic& problem) {
  return problem.value("key") == "map_file" ? "map_file" : std::string();
}

/// Radius or footprint of the local costmap, written into the scenario.
void takeNav2Body(ScenarioDocument& document, const Diagnostic& problem, const QString& text) {
  pushChange<sim2d::Robot>(document, problem.entity, text, [&](sim2d::Robot& robot) {
    if (auto shaped = app::withNav2Body(robot, document.path().toStdString())) {
      robot = *std::move(shaped);
    }
  });
}

using Filling = std::function<std::string(const ScenarioDocument&, const Diagnostic&)>;

/// What the problem itself says.
Filling said(const char* key) {
  return [key](const ScenarioDocument&, const Diagnostic& problem) { return problem.value(key); };
}

struct Rule {
  std::vector<std::string_view> codes;
  const char* words;
  Action mend;  // none: it needs a hand
  /// What fills the hole of the words; where it is empty the rule does not hold.
  Filling value = nullptr;
};

std::vector<Rule> rules() {
  return {
      {{"places.moved", "places.no-place"}, "Move it out of the wall", moveToFreePlace},
      {{"scenario.ids-not-in-order", "scenario.id-twice", "scenario.id-negative"},
       "Renumber people",
       renumberPeople},
      {{"scenario.goal-missing", "scenario.goal-below-one", "scenario.goal-twice"},
       "Renumber goals",
       renumberGoals},
      {{"scenario.goal-undefined", "places.no-way"},
       "Remove goal %1 from the route",
       leaveOutGoal,
       said("goal")},
      {{"places.no-way-to-point"}, "Remove the goal", edit<sim2d::Robot>([](sim2d::Robot& robot) {
         robot.goal.point.reset();
       })},
      {{"scenario.name-twice", "scenario.bad-person-name", "person.name-is-key",
        "scenario.bad-name"},
       "Give another name",
       giveFreeName},
      {{"person.out-of-range", "person.vel-too-high"},
       "Clamp to the range",
       edit<sim2d::Human>(clampNumbers)},
      {{"person.skin-unknown"}, "Clamp to the range", clampSkin},
      {{"person.behavior-incomplete"}, "Write these values", writeWholeReaction},
      {{"person.no-init-pose"}, "Write the start 0, 0", edit<sim2d::Human>([](sim2d::Human& human) {
         human.hasInitPose = true;
       })},
      {{"person.wait-count"}, "One wait for each goal", edit<sim2d::Human>([](sim2d::Human& human) {
         human.ours.wait.resize(human.goals.size(), 0.0);
       })},
      {{"person.no-goals"}, "Give goals…", {}},
      {{"scenario.unknown-word"}, "Use '%1'", useKnownWord, said("nearest")},
      {{"scenario.unknown-word"}, "Use the default", useKnownWord},
      {{"source.no-like", "source.like-unknown"}, "Copy %1", copyFirstPerson, firstPerson},
      {{"source.no-rate"}, "One every 10 s", edit<sim2d::Area>([](sim2d::Area& area) {
         area.rate = 0.1;
       })},
      {{"source.until-before-from"}, "Swap the times", edit<sim2d::Area>([](sim2d::Area& area) {
         std::swap(area.from, area.until);
       })},
      {{"shape.door-without-length"}, "Remove it", removeIt},
      {{"places.door-in-wall"}, "Open the wall", openWall},
      {{"scenario.map-name"}, "Write '%1'", writeMapName, plainMapName},
      {{"map.not-found", "map.not-named"}, "Open plane", openPlane},
      {{"map.not-there", "map.is-folder"}, "Open plane", openPlane, ownMapFile},
      {{"scenario.no-robot"}, "Add a robot", addRobot},
      {{"nav2.body-differs"}, "Take the body from the Nav2 file", takeNav2Body},
  };
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
    QString words = QObject::tr(rule.words);
    words.replace(QStringLiteral("%1"), QString::fromStdString(value));
    Fix fix{words, {}};
    if (rule.mend) {
      fix.apply = [mend = rule.mend, problem, words](ScenarioDocument& edited) {
        mend(edited, problem, words);
      };
    }
    return fix;
  }
  return std::nullopt;
}

void applyToAll(ScenarioDocument& document, const base::Diagnostics& problems,
                const QString& words) {
  document.undoStack().beginMacro(words);
  for (const base::Diagnostic& problem : problems) {
    const std::optional<Fix> fix = fixFor(document, problem);
    if (fix && fix->words == words && fix->apply) {
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
