
#include <QToolTip>

#include "app/run/Nav2Robots.h"
#include "editor/look/CoreText.h"
#include "editor/panels/properties/EntityPages.h"
#include "editor/panels/properties/PageWidgets.h"
#include "editor/run/SimulationRunner.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/RobotTypes.h"

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
      QObject::tr("Corners x y in the robot frame, such as 0.3 0.2; -0.3 0.2; -0.3 -0.2"),
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
             : QObject::tr("At least three corners x y, separated by semicolons");
}

/// A coordinate of the goal point. If only one is set, the other is that of the start.
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

/// The properties shown in the picture.
auto pictureProperties(const sim2d::ResolvedRobot& robot) {
  return std::tuple(robot.kinematics, robot.footprint, robot.radius, robot.maxVel, robot.maxOmega,
                    robot.turningRadius, robot.mass);
}

/// The type of a robot of the document; null: unknown type.
const sim2d::RobotType* typeOf(const Entity& entity) {
  return sim2d::findRobotType(robotOf(entity).type.value_or(sim2d::ResolvedRobot{}.type));
}

/// "0.22 m/s, 2.84 rad/s, 1.0 kg", and the source.
QString typeSummary(const std::string& name) {
  const sim2d::RobotType* const type = sim2d::findRobotType(name);
  if (type == nullptr) {
    return {};
  }
  QStringList labels;
  for (const auto& [word, figure] : RobotPicture::specificationsOf(sim2d::robotOfType(name))) {
    labels << figure;
  }
  if (type->lidar) {
    labels << QObject::tr("lidar %1 m").arg(type->lidar->range, 0, 'f', 1);
  }
  return QStringLiteral("<p>%1</p><p>%2</p>")
      .arg(labels.join(QStringLiteral(", ")).toHtmlEscaped(),
           QString::fromStdString(type->source).toHtmlEscaped());
}

/// A combo box of names that marks the default.
FieldOptions nameOptions(std::vector<std::string> names, const std::string& usual,
                         const std::function<QString(const std::string&)>& title,
                         const std::function<QString(const std::string&)>& hint) {
  FieldOptions look;
  for (const std::string& name : names) {
    look.labels << (name == usual ? QObject::tr("%1 (default)").arg(title(name)) : title(name));
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
                         return pictureProperties(bodyAndLimits(each));
                       }).has_value();
    picture_->show(isOne ? std::optional(bodyAndLimits(shown.front())) : std::nullopt);
  });
  addName(section);
  addListedRow(section);
  addTypeRows(section, registries);
  addPlannerRows(section, registries);
  FormSection* start = addSection(tr("Start"));
  addPosition(start);
  addRow(start, headingField());
  addField<Robot>(start, "start_time");
  addGoalSection();
  FormSection* parameters = addFold(tr("Parameters"));
  addParameterRows(parameters, plannersOf(registries),
                   tr("Parameters that are unknown to the planner or not numbers"));
  addNav2Section();
  FormSection* body = addFold(tr("Body and limits"));
  for (const char* key : {"radius", "mass", "max_vel", "max_acc", "max_omega", "max_alpha"}) {
    addField<Robot>(body, key);
  }
  addRow(body, footprintField(), withPlaceholder(tr("disc with the radius"), footprintProblem));
  addField<Robot>(body, "kinematics",
                  withLabels({tr("Differential"), tr("Omnidirectional"), tr("Ackermann")},
                             tr("As robot type (default)")));
  addField<Robot>(body, "turning_radius");
  addPart<sim2d::DetectorSettings>(
      tr("People perception"), tables,
      {{"kind", withLabels({tr("Visible people"), tr("All (ground truth)")}, tr("(default)"))},
       {"velocities", withLabels({tr("Ground truth"), tr("From positions")}, tr("(default)"))}});
  addPart<sim2d::LidarSettings>(tr("Lidar"), tables);
  addPart<sim2d::OdometrySettings>(tr("Odometry errors"), tables);
  addPart<sim2d::LocalizationSettings>(tr("Localisation"), tables);
  addPart<sim2d::BatterySettings>(tr("Battery"), tables);
  addRemainingFields<Robot>({"goals", "footprint_x", "footprint_y"});
}

/// A row per key of the table, in a collapsed section.
template <class Part>
void RobotPage::addPart(const QString& title, const sim2d::FieldTables& tables,
                        const std::map<std::string, FieldOptions>& looks) {
  FormSection* section = addFold(title);
  for (const sim2d::Field<Part>& field : sim2d::fieldsOf<Part>(tables)) {
    const auto look = looks.find(field.spec.key);
    addField<Part>(section, field.spec.key, look == looks.end() ? FieldOptions() : look->second);
  }
}

void RobotPage::setTheme(const Theme& theme) {
  picture_->setTheme(theme);
}

/// The type chooser, and the sources of the values of the chosen type.
void RobotPage::addTypeRows(FormSection* section, const sim2d::Registries& registries) {
  const auto title = [](const std::string& name) {
    const sim2d::RobotType* const type = sim2d::findRobotType(name);
    return coreText(type != nullptr ? type->title : name);
  };
  addField<Robot>(
      section, "type",
      nameOptions(registries.robotTypes.names(), sim2d::ResolvedRobot{}.type, title, typeSummary));
  source_ = linkButton(tr("Sources"), tr("Published data"), this, [this] {
    const QPoint below(0, source_->height());
    QToolTip::showText(source_->mapToGlobal(below), source_->toolTip(), source_);
  });
  source_->setObjectName(QStringLiteral("source"));
  section->addRow(QString(), source_);
  addRefresh([this, section](const std::vector<Entity>& shown) {
    const auto type = commonValue(shown, typeOf);
    section->setRowVisible(source_, type && *type != nullptr);
    if (type && *type != nullptr) {
      source_->setToolTip(typeSummary((*type)->name));
    }
  });
}

/// The planner chooser, and the description of the chosen planner.
void RobotPage::addPlannerRows(FormSection* section, const sim2d::Registries& registries) {
  std::map<std::string, QString> helps;
  for (const auto& planner : registries.planners.entries()) {
    helps[planner.name] = coreText(planner.help);
  }
  const auto helpOfName = [helps](const std::string& name) {
    const auto known = helps.find(name);
    return known == helps.end() ? QString() : known->second;
  };
  addField<Robot>(
      section, "planner",
      nameOptions(
          app::listedPlanners(registries), sim2d::ResolvedRobot{}.planner,
          [](const std::string& name) { return QString::fromStdString(name); }, helpOfName));
  FieldOptions command;
  command.visible = [](const std::vector<Entity>& shown) {
    return std::all_of(shown.begin(), shown.end(), [](const Entity& each) {
      return robotOf(each).planner == std::string(sim2d::kExternalPlanner) ||
             robotOf(each).command.has_value();
    });
  };
  addField<Robot>(section, "command", command);
  FieldOptions nav2;
  nav2.visible = [](const std::vector<Entity>& shown) {
    return std::all_of(shown.begin(), shown.end(), [](const Entity& each) {
      return robotOf(each).planner == std::string(sim2d::kNav2Planner);
    });
  };
  nav2.placeholder = tr("as generic robot");
  addField<Robot>(section, "nav2_params", nav2);
  nav2.placeholder = tr("Nav2 default");
  addField<Robot>(section, "nav2_tree", nav2);
  nav2.placeholder = tr("not published");
  addField<Robot>(section, "nav2_topics", nav2);
  nav2.placeholder.clear();
  addField<Robot>(section, "nav2_body", nav2);
  nav2.labels = QStringList{tr("Humble"), tr("Jazzy"), tr("Kilted"), tr("Lyrical"), tr("Main")};
  nav2.none = tr("As in the file (default)");
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

/// For one robot with Nav2: opens the panel with its parameters.
void RobotPage::addNav2Section() {
  FormSection* section = addSection(tr("Nav2 parameters"));
  QToolButton* open = linkButton(tr("Open Nav2 panel"),
                                 tr("Choose the parameter file and view or change all parameters"),
                                 this, [this] { Q_EMIT panelRequested(QStringLiteral("nav2")); });
  open->setObjectName(QStringLiteral("nav2_open"));
  section->addRow({}, open);
  QToolButton* body = section->addLink(
      tr("Use body"), tr("Use radius or footprint from local_costmap in the file"), [this] {
        apply(tr("Use the body in the Nav2 file"), [this](Entity& entity) {
          if (auto shaped = app::withNav2Body(robotOf(entity), document().path().toStdString())) {
            entity = *std::move(shaped);
          }
        });
      });
  body->setObjectName(QStringLiteral("nav2_take_body"));
  body->setVisible(true);
  addRefresh([section](const std::vector<Entity>& shown) {
    const Robot& robot = robotOf(shown.front());
    section->setVisible(shown.size() == 1 && robot.planner == std::string(sim2d::kNav2Planner));
    const std::size_t changed = robot.nav2Values.size();
    section->setNote(changed > 0 ? tr("%1 changed").arg(changed) : QString());
  });
}

void RobotPage::addGoalSection() {
  FormSection* section = addSection(tr("Goal"));
  addNumberPair(section, tr("Point"), goalField(tr("Goal X"), 0), goalField(tr("Goal Y"), 1));
  auto* route = new RouteEditor(document(), this);
  route->setToolTip(tr("Ordered global goals instead of a point"));
  section->addRow(tr("Or route"), route);
  connect(route, &RouteEditor::edited, this, [this](const std::vector<int>& goals) {
    apply(tr("Change robot route"), [&](Entity& entity) {
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
