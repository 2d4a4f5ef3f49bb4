#include "editor/document/FixEdits.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "editor/document/EditCommands.h"
#include "editor/document/EditDraft.h"
#include "editor/document/FreeNames.h"
#include "editor/document/RoutePlan.h"
#include "sim2d/map/PathPlanner.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace editor {

namespace {

constexpr double kFarthest = 30.0;  // [m]
constexpr double kMargin = 0.05;    // beside the radius, so that the place holds [m]

/// Rings of growing size round `centre`, in steps of a metre.
std::vector<Vec2> probes(const Vec2& centre) {
  std::vector<Vec2> points = {centre};
  for (double ring = 1.0; ring <= kFarthest; ring += 1.0) {
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

std::string allowedStem(const Entity& entity) {
  std::string stem;
  for (const char letter : nameOf(entity)) {
    const bool fine = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                      (letter >= '0' && letter <= '9') || letter == '_';
    stem += fine ? letter : '_';
  }
  const bool startsWell = !stem.empty() && (stem[0] < '0' || stem[0] > '9') && stem[0] != '_';
  return startsWell ? stem : kindName(kindOf(entity)).toStdString() + stem;
}

/// The nearest place within 30 m where a body fits between walls and obstacles, `near` itself when
/// it does; nothing when there is none.
std::optional<Vec2> freePlace(const ScenarioDocument& document, const Vec2& near, double radius) {
  const sim2d::Scenario& scenario = document.scenario();
  const sim2d::Surroundings around = sim2d::makeSurroundings(scenario, *document.map());
  const std::vector<Vec2> points = probes(near);
  const auto field = std::make_shared<sim2d::DistanceField>(around.grid, around.obstacles, points);
  for (const double margin : {kMargin, 0.0}) {
    const sim2d::PathPlanner planner(field, radius + margin);
    for (const Vec2& point : points) {
      if (const std::optional<Vec2> fit = planner.nearestFit(point)) {
        return fit;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

void moveToFreePlace(ScenarioDocument& document, EntityId id, bool robotGoal, const QString& text) {
  std::optional<Entity> value = document.entity(id);
  if (!value) {
    return;
  }
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

void renumberPeople(ScenarioDocument& document, const QString& text) {
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

void renumberGoals(ScenarioDocument& document, const QString& text) {
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
  const auto follow = [&numbers](std::vector<int>& route) {
    for (int& goal : route) {
      const auto found = numbers.find(goal);
      goal = found == numbers.end() ? goal : found->second;
    }
  };
  draft.forEach<sim2d::Human>([&](sim2d::Human& human) { follow(human.goals); });
  draft.forEach<sim2d::Robot>([&](sim2d::Robot& robot) { follow(robot.goal.goals); });
  draft.push(document, text);
}

void dropGoal(ScenarioDocument& document, EntityId id, int goal, const QString& text) {
  std::optional<Entity> value = document.entity(id);
  const auto without = [goal](std::vector<int> goals) {
    goals.erase(std::remove(goals.begin(), goals.end(), goal), goals.end());
    return goals;
  };
  if (auto* human = value ? std::get_if<sim2d::Human>(&*value) : nullptr) {
    setGoals(*human, without(human->goals));
  } else if (auto* robot = value ? std::get_if<sim2d::Robot>(&*value) : nullptr) {
    robot->goal.goals = without(robot->goal.goals);
  } else {
    return;
  }
  pushEdit(document, {*std::move(value)}, text);
}

void giveFreeName(ScenarioDocument& document, EntityId id, const QString& text) {
  std::optional<Entity> value = document.entity(id);
  if (!value) {
    return;
  }
  const std::string stem = allowedStem(*value);
  const bool usable = stem != nameOf(*value) && !isNameTaken(document.scenario(), stem);
  setName(*value, usable ? stem : freeName(document.scenario(), stem));
  pushEdit(document, {*std::move(value)}, text);
}

void addRobot(ScenarioDocument& document) {
  Vec2 centre = Vec2::Zero();
  int count = 0;
  for (const sim2d::Human& human : document.scenario().humans) {
    centre += human.initPose.position;
    ++count;
  }
  centre /= std::max(count, 1);
  const double radius = sim2d::resolveRobot({}, {}, -1).radius;
  sim2d::Robot robot;
  const Vec2 start = centre + Vec2(-2.0, 0.0);
  const Vec2 goal = centre + Vec2(2.0, 0.0);
  robot.start.position = freePlace(document, start, radius).value_or(start);
  robot.goal.point = freePlace(document, goal, radius).value_or(goal);
  robot.start.heading = base::headingOf(*robot.goal.point - robot.start.position);
  document.setSelection({pushAdd(document, robot)});
}

}  // namespace editor
