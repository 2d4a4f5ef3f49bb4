#include "editor/document/RunValues.h"

#include "editor/document/PeopleEdits.h"
#include "sim2d/scenario/Fields.h"

namespace editor {

namespace {

/// `take` takes a member from the run unless it was edited.
template <class T, class... Member>
void takeUnedited(T& value, const T& start, const T& run, Member... members) {
  const auto take = [&](auto member) {
    if (value.*member == start.*member) {
      value.*member = run.*member;
    }
  };
  (take(members), ...);
}

/// The values that a branch can change.
void takeRunValues(sim2d::Robot& robot, const sim2d::Robot& start, const sim2d::Robot& run) {
  using R = sim2d::Robot;
  takeUnedited(robot, start, run, &R::planner, &R::command, &R::plannerParameters, &R::nav2Params,
               &R::nav2Tree, &R::nav2Distro, &R::nav2Topics, &R::nav2Values, &R::goalRadius,
               &R::maxVel, &R::maxAcc, &R::maxOmega, &R::maxAlpha);
  takeUnedited(robot.goal, start.goal, run.goal, &sim2d::RobotGoal::point,
               &sim2d::RobotGoal::goals);
}

void takeRunValues(ScenarioSettings& settings, const ScenarioSettings& start,
                   const ScenarioSettings& run) {
  for (const auto& field : sim2d::fieldsOf<sim2d::DesktopSettings>()) {
    if (!field.isStructure() && field.equal(settings.desktop, start.desktop)) {
      field.assign(settings.desktop, field.value(run.desktop));
    }
  }
}

}  // namespace

Entity withRunValues(const ScenarioDocument& document, Entity entity) {
  const std::optional<Entity> start = document.entityAtRunStart(idOf(entity));
  const std::optional<Entity> run = document.entityInRun(idOf(entity));
  if (!start || !run) {
    return entity;
  }
  if (auto* robot = std::get_if<sim2d::Robot>(&entity)) {
    takeRunValues(*robot, std::get<sim2d::Robot>(*start), std::get<sim2d::Robot>(*run));
  } else if (auto* settings = std::get_if<ScenarioSettings>(&entity)) {
    takeRunValues(*settings, std::get<ScenarioSettings>(*start), std::get<ScenarioSettings>(*run));
  }
  return entity;
}

Look shownLookOf(const ScenarioDocument& document, const sim2d::Human& human) {
  const std::optional<Entity> run = document.entityInRun(human.key);
  if (!run) {
    return lookOfPerson(document, human);
  }
  sim2d::Human shown = std::get<sim2d::Human>(*run);
  shown.key = human.key;  // Of its tree.
  return lookOfPerson(document, shown);
}

std::set<int> customTreesOf(const sim2d::TraceHeader& run) {
  std::set<int> ids;
  for (const sim2d::TraceHuman& human : run.humans) {
    if (human.customTree) {
      ids.insert(human.id);
    }
  }
  return ids;
}

}  // namespace editor
