#include <algorithm>

#include "editor/panels/EntityPages.h"
#include "editor/panels/KeyAccess.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/world/Registries.h"

namespace editor {

namespace {

using sim2d::Robot;

constexpr NumberField::Range kTime = {0.0, 86400.0, 1, 1.0};

const Robot& robotOf(const Entity& entity) {
  return std::get<Robot>(entity);
}

NumberKey robotNumber(const QString& label, const QString& unit, const NumberField::Range& range,
                      std::optional<double> Robot::*member, double sim2d::ResolvedRobot::*what) {
  NumberKey key = numberKey(label, unit, range, member, 0.0);
  key.fallback = [what](const Entity& entity) {
    return sim2d::resolveRobot({}, robotOf(entity), -1).*what;
  };
  return key;
}

/// "lookahead=0.6, stop_distance=0.5"
QString exampleParameters() {
  const sim2d::Registries all = sim2d::programRegistries();
  const std::vector<base::ParameterSpec>& specs =
      all.planners.find(sim2d::ResolvedRobot{}.planner)->parameters;
  QStringList examples;
  for (const base::ParameterSpec& spec : {specs.front(), specs.back()}) {
    examples += QString::fromStdString(spec.key + "=" +
                                       base::formatDouble(std::get<double>(spec.fallback)));
  }
  return examples.join(QStringLiteral(", "));
}

}  // namespace

RobotPage::RobotPage(ScenarioDocument& document, QWidget* parent) : PropertyPage(document, parent) {
  FormSection* section = addSection(tr("Robot"));
  addName(section);
  addSwitch(section, listedKey());
  addChoice(section, nameChoice(
                         tr("Type"), tr("generic (default)"), sim2d::robotTypeNames(),
                         [](Entity & e) -> auto& { return std::get<Robot>(e).type; }));
  addChoice(section, nameChoice(
                         tr("Planner"), tr("pursuit (default)"), sim2d::plannerNames(),
                         [](Entity & e) -> auto& { return std::get<Robot>(e).planner; }));
  TextKey parameters;
  parameters.label = tr("Parameters");
  parameters.placeholder = tr("the planner's");
  parameters.hint = tr("Of the planner, such as %1").arg(exampleParameters());
  parameters.get = [](const Entity& e) { return pairsText(robotOf(e).plannerParameters); };
  parameters.set = [](Entity& e, const QString& text) {
    std::get<Robot>(e).plannerParameters = *pairsFromText(text);
  };
  parameters.check = [](const QString& text) {
    return pairsFromText(text) ? QString() : tr("name=value, with commas between them");
  };
  addText(section, parameters);
  FormSection* start = addSection(tr("Start"));
  addNumberPair(start, tr("Position"), xKey(), yKey());
  addNumber(start, headingKey());
  addNumber(start, robotNumber(tr("Sets off at"), tr("s"), kTime, &Robot::startTime,
                               &sim2d::ResolvedRobot::startTime));
  addGoalSection();
  addLimitSection();
  finish();
}

void RobotPage::addGoalSection() {
  FormSection* section = addSection(tr("Goal"));
  const auto pointKey = [](const QString& label, int axis) {
    NumberKey key = xKey();
    key.label = label;
    key.get = [axis](const Entity& entity) -> std::optional<double> {
      const std::optional<Vec2>& point = robotOf(entity).goal.point;
      return point ? std::optional((*point)(axis)) : std::nullopt;
    };
    key.set = [axis](Entity& entity, std::optional<double> value) {
      Robot& robot = std::get<Robot>(entity);
      robot.goal.goals.clear();
      if (!value) {
        robot.goal.point.reset();
        return;
      }
      Vec2 point = robot.goal.point.value_or(robot.start.position);
      point(axis) = *value;
      robot.goal.point = point;
    };
    key.fallback = [axis](const Entity& entity) { return robotOf(entity).start.position(axis); };
    return key;
  };
  addNumberPair(section, tr("Point"), pointKey(tr("Goal X"), 0), pointKey(tr("Goal Y"), 1));
  auto* route = new RouteEditor(document(), this);
  route->setToolTip(tr("Global goals in order, instead of a point"));
  section->addRow(tr("Or route"), route);
  connect(route, &RouteEditor::edited, this, [this](const std::vector<int>& goals) {
    apply(tr("Change the robot's route"), [&](Entity& entity) {
      Robot& robot = std::get<Robot>(entity);
      robot.goal.point.reset();
      robot.goal.goals = goals;
    });
  });
  addRefresh([route, section](const std::vector<Entity>& shown) {
    const sim2d::RobotGoal& goal = robotOf(shown.front()).goal;
    route->show(goal.goals);
    section->setNote(goal.point || !goal.goals.empty() ? QString() : tr("stands still"));
  });
  addNumber(section, robotNumber(tr("Arrival radius"), tr("m"), {0.01, 5.0, 2, 0.05},
                                 &Robot::goalRadius, &sim2d::ResolvedRobot::goalRadius));
}

void RobotPage::addLimitSection() {
  using Resolved = sim2d::ResolvedRobot;
  FormSection* section = addSection(tr("Body and limits"));
  const auto add = [&](const QString& label, const QString& unit, NumberField::Range range,
                       std::optional<double> Robot::*member, double Resolved::*what,
                       double sliderTo) {
    NumberKey key = robotNumber(label, unit, range, member, what);
    key.sliderTo = sliderTo;
    addNumber(section, key);
  };
  add(tr("Radius"), tr("m"), {0.05, 3.0, 2, 0.01}, &Robot::radius, &Resolved::radius, 1.0);
  add(tr("Mass"), tr("kg"), {0.1, 5000.0, 1, 1.0}, &Robot::mass, &Resolved::mass, 0.0);
  add(tr("Top speed"), tr("m/s"), {0.0, 5.0, 2, 0.05}, &Robot::maxVel, &Resolved::maxVel, 2.0);
  add(tr("Acceleration"), tr("m/s²"), {0.01, 20.0, 2, 0.1}, &Robot::maxAcc, &Resolved::maxAcc, 3.0);
  add(tr("Turn speed"), tr("rad/s"), {0.01, 20.0, 2, 0.1}, &Robot::maxOmega, &Resolved::maxOmega,
      0.0);
  add(tr("Turn accel."), tr("rad/s²"), {0.01, 50.0, 2, 0.1}, &Robot::maxAlpha, &Resolved::maxAlpha,
      0.0);
  TextKey footprint;
  footprint.label = tr("Footprint");
  footprint.placeholder = tr("a disc of the radius");
  footprint.hint = tr("Corners x y in the robot's frame, such as 0.3 0.2; -0.3 0.2; -0.3 -0.2");
  footprint.get = [](const Entity& entity) {
    const Robot& robot = robotOf(entity);
    std::vector<Vec2> corners;
    for (std::size_t i = 0; i < std::min(robot.footprintX.size(), robot.footprintY.size()); ++i) {
      corners.emplace_back(robot.footprintX[i], robot.footprintY[i]);
    }
    return pointsText(corners);
  };
  footprint.set = [](Entity& entity, const QString& text) {
    Robot& robot = std::get<Robot>(entity);
    robot.footprintX.clear();
    robot.footprintY.clear();
    const auto corners = pointsFromText(text);
    for (const Vec2& corner : corners.value()) {
      robot.footprintX.push_back(corner.x());
      robot.footprintY.push_back(corner.y());
    }
  };
  footprint.check = [](const QString& text) {
    const auto corners = pointsFromText(text);
    return corners && (corners->empty() || corners->size() >= 3)
               ? QString()
               : tr("At least three corners x y, with semicolons between them");
  };
  addText(section, footprint);
}

}  // namespace editor
