#include <algorithm>

#include "editor/panels/EntityPages.h"
#include "editor/panels/ListText.h"
#include "sim2d/base/Text.h"
#include "sim2d/world/Registries.h"

namespace editor {

namespace {

using sim2d::Robot;

const Robot& robotOf(const Entity& entity) {
  return std::get<Robot>(entity);
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

EntityField footprintField() {
  return textField(
      QObject::tr("Footprint"),
      QObject::tr("Corners x y in the robot's frame, such as 0.3 0.2; -0.3 0.2; -0.3 -0.2"),
      [](const Entity& entity) {
        const Robot& robot = robotOf(entity);
        std::vector<Vec2> corners;
        for (std::size_t i = 0; i < std::min(robot.footprintX.size(), robot.footprintY.size());
             ++i) {
          corners.emplace_back(robot.footprintX[i], robot.footprintY[i]);
        }
        return pointsText(corners);
      },
      [](Entity& entity, const QString& text) {
        Robot& robot = std::get<Robot>(entity);
        robot.footprintX.clear();
        robot.footprintY.clear();
        const auto corners = pointsFromText(text);
        for (const Vec2& corner : corners.value()) {
          robot.footprintX.push_back(corner.x());
          robot.footprintY.push_back(corner.y());
        }
      });
}

QString footprintProblem(const QString& text) {
  const auto corners = pointsFromText(text);
  return corners && (corners->empty() || corners->size() >= 3)
             ? QString()
             : QObject::tr("At least three corners x y, with semicolons between them");
}

/// A coordinate of the goal point; the first one given takes the other from the start.
EntityField goalField(const QString& label, int axis) {
  EntityField field = numberField(
      label, QStringLiteral("m"),
      [axis](const Entity& entity) -> std::optional<double> {
        const std::optional<Vec2>& point = robotOf(entity).goal.point;
        return point ? std::optional((*point)(axis)) : std::nullopt;
      },
      [axis](Entity& entity, std::optional<double> value) {
        Robot& robot = std::get<Robot>(entity);
        robot.goal.goals.clear();
        if (!value) {
          robot.goal.point.reset();
          return;
        }
        Vec2 point = robot.goal.point.value_or(robot.start.position);
        point(axis) = *value;
        robot.goal.point = point;
      });
  field.fallback = [axis](const Entity& entity) { return robotOf(entity).start.position(axis); };
  return field;
}

}  // namespace

RobotPage::RobotPage(ScenarioDocument& document, QWidget* parent, const sim2d::FieldTables& tables)
    : PropertyPage(document, parent, tables) {
  FormSection* section = addSection(tr("Robot"));
  addName(section);
  addListed(section);
  addField<Robot>(section, "type", oneOf(sim2d::robotTypeNames(), tr("generic (default)")));
  addField<Robot>(section, "planner", oneOf(sim2d::plannerNames(), tr("pursuit (default)")));
  addRow(section,
         textField(
             tr("Parameters"), tr("Of the planner, such as %1").arg(exampleParameters()),
             [](const Entity& e) { return pairsText(robotOf(e).plannerParameters); },
             [](Entity& e, const QString& text) {
               std::get<Robot>(e).plannerParameters = *pairsFromText(text);
             }),
         emptyAs(tr("the planner's"), [](const QString& text) {
           return pairsFromText(text) ? QString() : tr("name=value, with commas between them");
         }));
  FormSection* start = addSection(tr("Start"));
  addNumberPair(start, tr("Position"), xField(), yField());
  addRow(start, headingField());
  addField<Robot>(start, "start_time");
  addGoalSection();
  FormSection* body = addSection(tr("Body and limits"));
  for (const char* key : {"radius", "mass", "max_vel", "max_acc", "max_omega", "max_alpha"}) {
    addField<Robot>(body, key);
  }
  addRow(body, footprintField(), emptyAs(tr("a disc of the radius"), footprintProblem));
  addNewFields<Robot>({"goals", "footprint_x", "footprint_y"});
  finish();
}

void RobotPage::addGoalSection() {
  FormSection* section = addSection(tr("Goal"));
  addNumberPair(section, tr("Point"), goalField(tr("Goal X"), 0), goalField(tr("Goal Y"), 1));
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
  addField<Robot>(section, "goal_radius");
}

}  // namespace editor
