#include <algorithm>
#include <utility>

#include <QToolTip>

#include "app/run/Nav2Body.h"
#include "editor/panels/EntityPages.h"
#include "editor/panels/Nav2Form.h"
#include "editor/panels/RobotPicture.h"
#include "editor/panels/RouteEditor.h"
#include "editor/run/SimulationRunner.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/RobotTypes.h"
#include "sim2d/nav/external/CodePermission.h"

namespace editor {

namespace {

using sim2d::Robot;

const Robot& robotOf(const Entity& entity) {
  return std::get<Robot>(entity);
}

ParameterOwner plannersOf(const sim2d::Registries& registries) {
  ParameterOwner owner;
  owner.known = sim2d::knownNames(registries).plannerParameters;
  owner.name = [](const Entity& entity) {
    return robotOf(entity).planner.value_or(sim2d::ResolvedRobot{}.planner);
  };
  owner.given = [](const Entity& entity) { return robotOf(entity).plannerParameters; };
  owner.give = [](Entity& entity, sim2d::ParameterTexts texts) {
    std::get<Robot>(entity).plannerParameters = std::move(texts);
  };
  return owner;
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

sim2d::ResolvedRobot bodyAndLimits(const Entity& entity) {
  return sim2d::resolveRobot({}, robotOf(entity), -1);
}

/// What the picture shows of a robot.
auto looksOf(const sim2d::ResolvedRobot& robot) {
  return std::tuple(robot.kinematics, robot.footprint, robot.radius, robot.maxVel, robot.maxOmega,
                    robot.turningRadius, robot.mass);
}

/// The type as a robot of the document; null: nobody knows it.
const sim2d::RobotType* typeOf(const Entity& entity) {
  return sim2d::findRobotType(robotOf(entity).type.value_or(sim2d::ResolvedRobot{}.type));
}

/// "0.22 m/s, 2.84 rad/s, 1.0 kg", and the source.
QString publishedOf(const std::string& name) {
  const sim2d::RobotType* const type = sim2d::findRobotType(name);
  if (type == nullptr) {
    return {};
  }
  QStringList words;
  for (const auto& [word, figure] : RobotPicture::figuresOf(sim2d::robotOfType(name))) {
    words << figure;
  }
  if (type->lidar) {
    words << QObject::tr("lidar %1 m").arg(type->lidar->range, 0, 'f', 1);
  }
  return QStringLiteral("<p>%1</p><p>%2</p>")
      .arg(words.join(QStringLiteral(", ")).toHtmlEscaped(),
           QString::fromStdString(type->source).toHtmlEscaped());
}

/// A field with no label that takes the place of one too.
void overBothColumns(QWidget& field) {
  auto* grid = qobject_cast<QGridLayout*>(field.parentWidget()->layout());
  int row = 0, column = 0, rows = 0, columns = 0;
  grid->getItemPosition(grid->indexOf(&field), &row, &column, &rows, &columns);
  grid->removeWidget(&field);
  grid->addWidget(&field, row, 0, rows, column + columns);
}

/// A chooser of names, the usual one marked as it counts without a word in the file.
FieldLook namesLook(std::vector<std::string> names, const std::string& usual,
                    const std::function<QString(const std::string&)>& title,
                    const std::function<QString(const std::string&)>& hint) {
  FieldLook look;
  for (const std::string& name : names) {
    look.words << (name == usual ? QObject::tr("%1 (default)").arg(title(name)) : title(name));
    look.hints << hint(name);
  }
  look.names = std::move(names);
  return look;
}

}  // namespace

RobotPage::RobotPage(ScenarioDocument& document, const sim2d::FieldTables& tables,
                     const sim2d::Registries& registries)
    : PropertyPage(document, tables), picture_(new RobotPicture(this)) {
  FormSection* section = addSection(tr("Robot"));
  addOnTop(picture_);
  addRefresh([this](const std::vector<Entity>& shown) {
    const bool isOne = commonValue(shown, [](const Entity& each) {
                         return looksOf(bodyAndLimits(each));
                       }).has_value();
    picture_->show(isOne ? std::optional(bodyAndLimits(shown.front())) : std::nullopt);
  });
  addName(section);
  addListed(section);
  addTypeRows(section, registries);
  addPlannerRows(section, registries);
  FormSection* start = addSection(tr("Start"));
  addPosition(start);
  addRow(start, headingField());
  addField<Robot>(start, "start_time");
  addGoalSection();
  FormSection* parameters = addFold(tr("Parameters"));
  addParameterRows(parameters, plannersOf(registries),
                   tr("Parameters that the planner does not have or that are no numbers"));
  addNav2Section();
  FormSection* body = addFold(tr("Body and limits"));
  for (const char* key : {"radius", "mass", "max_vel", "max_acc", "max_omega", "max_alpha"}) {
    addField<Robot>(body, key);
  }
  addRow(body, footprintField(), emptyAs(tr("a disc of the radius"), footprintProblem));
  addField<Robot>(body, "kinematics",
                  inWords({tr("Two wheels"), tr("Every direction"), tr("Like a car")},
                          tr("As the type (default)")));
  addField<Robot>(body, "turning_radius");
  addPart<sim2d::DetectorSettings>(
      tr("Knows of people"), tables,
      {{"kind", inWords({tr("What it sees"), tr("Everybody (ground truth)")}, tr("(default)"))},
       {"velocities", inWords({tr("As they are"), tr("From places")}, tr("(default)"))}});
  addPart<sim2d::LidarSettings>(tr("Lidar"), tables);
  addPart<sim2d::OdometrySettings>(tr("Errors of odometry"), tables);
  addPart<sim2d::LocalizationSettings>(tr("Localisation"), tables);
  addPart<sim2d::BatterySettings>(tr("Battery"), tables);
  addNewFields<Robot>({"goals", "footprint_x", "footprint_y"});
}

/// A row per key of the table, folded: most people leave them as they are.
template <class Part>
void RobotPage::addPart(const QString& title, const sim2d::FieldTables& tables,
                        const std::map<std::string, FieldLook>& looks) {
  FormSection* section = addFold(title);
  for (const sim2d::Field<Part>& field : sim2d::fieldsOf<Part>(tables)) {
    const auto look = looks.find(field.spec.key);
    addField<Part>(section, field.spec.key, look == looks.end() ? FieldLook() : look->second);
  }
}

void RobotPage::setTheme(const Theme& theme) {
  picture_->setTheme(theme);
  nav2_->setTheme(theme);
}

/// The chooser, and where the figures of the chosen type are from.
void RobotPage::addTypeRows(FormSection* section, const sim2d::Registries& registries) {
  const auto title = [](const std::string& name) {
    const sim2d::RobotType* const type = sim2d::findRobotType(name);
    return QString::fromStdString(type != nullptr ? type->title : name);
  };
  addField<Robot>(
      section, "type",
      namesLook(registries.robotTypes.names(), sim2d::ResolvedRobot{}.type, title, publishedOf));
  source_ = linkButton(tr("Where its figures are from"), tr("What was published"), this, [this] {
    const QPoint below(0, source_->height());
    QToolTip::showText(source_->mapToGlobal(below), source_->toolTip(), source_);
  });
  source_->setObjectName(QStringLiteral("source"));
  section->addRow(QString(), source_);
  addRefresh([this, section](const std::vector<Entity>& shown) {
    const auto type = commonValue(shown, typeOf);
    section->setRowVisible(source_, type && *type != nullptr);
    if (type && *type != nullptr) {
      source_->setToolTip(publishedOf((*type)->name));
    }
  });
}

/// The chooser, and what the chosen planner does.
void RobotPage::addPlannerRows(FormSection* section, const sim2d::Registries& registries) {
  std::map<std::string, QString> helps;
  for (const auto& planner : registries.planners.entries()) {
    helps[planner.name] = QString::fromStdString(planner.help);
  }
  const auto helpOfName = [helps](const std::string& name) {
    const auto known = helps.find(name);
    return known == helps.end() ? QString() : known->second;
  };
  addField<Robot>(
      section, "planner",
      namesLook(
          registries.planners.names(), sim2d::ResolvedRobot{}.planner,
          [](const std::string& name) { return QString::fromStdString(name); }, helpOfName));
  FieldLook command;
  command.visible = [](const std::vector<Entity>& shown) {
    return std::all_of(shown.begin(), shown.end(), [](const Entity& each) {
      return robotOf(each).planner == std::string(sim2d::kExternalPlanner) ||
             robotOf(each).command.has_value();
    });
  };
  addField<Robot>(section, "command", command);
  FieldLook nav2;
  nav2.visible = [](const std::vector<Entity>& shown) {
    return std::all_of(shown.begin(), shown.end(), [](const Entity& each) {
      return robotOf(each).planner == std::string(sim2d::kNav2Planner);
    });
  };
  nav2.placeholder = tr("of the generic robot");
  addField<Robot>(section, "nav2_params", nav2);
  nav2.placeholder = tr("Nav2's own");
  addField<Robot>(section, "nav2_tree", nav2);
  nav2.placeholder = tr("nothing is published");
  addField<Robot>(section, "nav2_topics", nav2);
  nav2.words = QStringList{tr("Humble"), tr("Jazzy"), tr("Kilted"), tr("Lyrical"), tr("Main")};
  nav2.none = tr("As the file tells (default)");
  addField<Robot>(section, "nav2_distro", nav2);
  QLabel* help = secondaryLabel({}, this);
  help->setObjectName(QStringLiteral("planner_help"));
  help->setWordWrap(true);
  help->setTextFormat(Qt::PlainText);
  section->addRow(QString(), help);
  addRefresh([=, name = plannersOf(registries).name](const std::vector<Entity>& shown) {
    const auto planner = commonValue(shown, name);
    help->setText(planner ? helpOfName(*planner) : QString());
    section->setRowVisible(help, !help->text().isEmpty());
  });
}

/// Of one robot with Nav2: what its file says, and what the scenario says instead.
void RobotPage::addNav2Section() {
  FormSection* section = addSection(tr("Parameters of Nav2"));
  section->setOpen(false);
  nav2_ = new Nav2Form(this);
  section->addRow({}, nav2_);
  overBothColumns(*nav2_);
  QToolButton* all = section->addLink(tr("Reset"), tr("Take all values of the file again"), [this] {
    apply(tr("Take the file's parameters of Nav2"),
          [](Entity& entity) { std::get<Robot>(entity).nav2Values.clear(); });
  });
  QToolButton* body = section->addLink(
      tr("Take the body"), tr("Take radius or footprint from local_costmap of the file"), [this] {
        apply(tr("Take the body from the Nav2 file"), [this](Entity& entity) {
          if (auto shaped = app::withNav2Body(robotOf(entity), document().path().toStdString())) {
            entity = *std::move(shaped);
          }
        });
      });
  body->setObjectName(QStringLiteral("nav2_take_body"));
  connect(nav2_, &Nav2Form::edited, this,
          [this](const app::Nav2Parameter& parameter, const std::optional<std::string>& yaml) {
            apply(tr("Change %1").arg(QString::fromStdString(parameter.path)), [&](Entity& entity) {
              entity = app::withNav2Value(robotOf(entity), parameter, yaml);
            });
          });
  addRefresh([this, section, all](const std::vector<Entity>& shown) {
    const Robot& robot = robotOf(shown.front());
    const bool isNav2 = shown.size() == 1 && robot.planner == std::string(sim2d::kNav2Planner);
    section->setVisible(isNav2);
    nav2_->show(isNav2 ? std::optional(robot) : std::nullopt, document().path());
    const int changed = nav2_->changedCount();
    section->setNote(changed > 0 ? tr("%1 changed").arg(changed) : QString());
    all->setVisible(changed > 0);
  });
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
  addRefresh([this, route, section](const std::vector<Entity>& shown) {
    const sim2d::RobotGoal& goal = robotOf(shown.front()).goal;
    const bool drives = goal.point || !goal.goals.empty();
    const bool isEnd = !runEndText(this->document().scenario()).isEmpty();
    route->show(goal.goals);
    section->setNote(!drives ? tr("stands still") : isEnd ? tr("ends the run") : QString());
  });
  addField<Robot>(section, "goal_radius");
}

}  // namespace editor
