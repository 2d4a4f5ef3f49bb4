#include "editor/panels/EntityPages.h"

#include <algorithm>
#include <utility>

#include "editor/panels/RouteEditor.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

namespace {

using sim2d::Area;
using sim2d::Door;
using sim2d::Obstacle;
using sim2d::ObstacleKind;

constexpr int kMostVisitors = 12;  // by name

/// All of them are obstacles of one of the kinds.
bool areOf(const std::vector<Entity>& shown, const std::vector<ObstacleKind>& kinds) {
  return std::all_of(shown.begin(), shown.end(), [&](const Entity& each) {
    return std::count(kinds.begin(), kinds.end(), std::get<Obstacle>(each).kind) > 0;
  });
}

template <class T>
EntityField cornersField() {
  return textField(
      QObject::tr("Corners"), QObject::tr("x y [m], with semicolons between them"),
      [](const Entity& entity) { return pointsText(std::get<T>(entity).points); },
      [](Entity& entity, const QString& text) {
        std::get<T>(entity).points = *pointsFromText(text);
      });
}

QString cornersProblem(const QString& text, std::size_t least) {
  const auto corners = pointsFromText(text);
  return corners && corners->size() >= least
             ? QString()
             : QObject::tr("At least %1 corners x y, with semicolons between them").arg(least);
}

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

class GoalPage : public PropertyPage {
 public:
  explicit GoalPage(ScenarioDocument& document) : PropertyPage(document) {
    FormSection* section = addSection(tr("Goal"));
    addOwnNumber(
        section, {}, 1, [](const Entity& goal) { return std::get<sim2d::GlobalGoal>(goal).id; },
        [this](int number) { return pushGoalNumber(this->document(), targets().front(), number); });
    addPosition(section);
    auto* users = secondaryLabel({}, this);
    users->setWordWrap(true);
    section->addRow(tr("Visited by"), users);
    addRefresh([this, users](const std::vector<Entity>& shown) {
      users->setText(shown.size() == 1 ? visitorsOf(std::get<sim2d::GlobalGoal>(shown.front()).id)
                                       : tr("several goals are selected"));
    });
  }

 private:
  QString visitorsOf(int goal) const {
    QStringList names;
    for (const sim2d::Human& human : document().scenario().humans) {
      if (std::find(human.goals.begin(), human.goals.end(), goal) != human.goals.end()) {
        names.push_back(QString::fromStdString(human.name));
      }
    }
    const int more = static_cast<int>(names.size()) - kMostVisitors;
    if (names.isEmpty()) {
      return tr("nobody yet");
    }
    const QString first = names.mid(0, kMostVisitors).join(QStringLiteral(", "));
    return more > 0 ? tr("%1 and %2 more").arg(first).arg(more) : first;
  }
};

class ObstaclePage : public PropertyPage {
 public:
  explicit ObstaclePage(ScenarioDocument& document) : PropertyPage(document) {
    FormSection* section = addSection(tr("Obstacle"));
    addName(section);
    addListed(section);
    addPosition(section);
    FieldLook ofBox;
    ofBox.visible = [](const std::vector<Entity>& shown) {
      return areOf(shown, {ObstacleKind::Box});
    };
    addRow(section, headingField(), ofBox);
    for (const char* key : {"length", "width", "radius", "thickness"}) {
      addField<Obstacle>(section, key);
    }
    FieldLook corners = emptyAs({}, [this](const QString& text) {
      return cornersProblem(text, areOf(values(), {ObstacleKind::Wall}) ? 2 : 3);
    });
    corners.visible = [](const std::vector<Entity>& shown) {
      return areOf(shown, {ObstacleKind::Polygon, ObstacleKind::Wall});
    };
    addRow(section, cornersField<Obstacle>(), corners);
    addNewFields<Obstacle>({"kind", "x", "y", "h"});
    addRefresh([section](const std::vector<Entity>& shown) {
      const ObstacleKind first = std::get<Obstacle>(shown.front()).kind;
      section->setNote(areOf(shown, {first}) ? obstacleKindName(first) : tr("several shapes"));
    });
  }
};

class DoorPage : public PropertyPage {
 public:
  explicit DoorPage(ScenarioDocument& document) : PropertyPage(document) {
    FormSection* section = addSection(tr("Door"));
    addName(section);
    addListed(section);
    const auto end = [](const QString& label, Vec2 Door::*point, int axis) {
      return numberField(
          label, QStringLiteral("m"),
          [=](const Entity& door) { return std::optional((std::get<Door>(door).*point)(axis)); },
          [=](Entity& door, std::optional<double> value) {
            double& at = (std::get<Door>(door).*point)(axis);
            at = value.value_or(at);  // it cannot be left out
          });
    };
    addNumberPair(section, tr("From"), end(tr("From X"), &Door::from, 0),
                  end(tr("From Y"), &Door::from, 1));
    addNumberPair(section, tr("To"), end(tr("To X"), &Door::to, 0), end(tr("To Y"), &Door::to, 1));
    addField<Door>(section, "thickness");
    addField<Door>(section, "open", inWords({tr("Open")}));
    addField<Door>(
        section, "toggles", emptyAs(tr("seconds, such as 5, 12.5"), [](const QString& text) {
          const auto times = listFromText(text);
          const bool fine = times && std::is_sorted(times->begin(), times->end()) &&
                            (times->empty() || times->front() >= 0.0);
          return fine ? QString() : tr("Times in seconds, ascending, with commas between them");
        }));
    addNewFields<Door>({"x1", "y1", "x2", "y2"});
  }
};

class AreaPage : public PropertyPage {
 public:
  explicit AreaPage(ScenarioDocument& document) : PropertyPage(document) {
    FormSection* section = addSection(tr("Area"));
    addName(section);
    addListed(section);
    addField<Area>(section, "kind",
                   inWords({tr("Source: people come in"), tr("Sink: people leave"),
                            tr("Waiting area"), tr("Exit")}));
    addPosition(section);
    addRow(section, cornersField<Area>(),
           emptyAs({}, [](const QString& text) { return cornersProblem(text, 3); }));
    FormSection* source = addSection(tr("Who comes in"));
    addField<Area>(source, "like", emptyAs(tr("name of a person"), [this](const QString& text) {
                     const sim2d::Scenario& scenario = this->document().scenario();
                     const bool known =
                         text.isEmpty() || scenario.human(text.toStdString()) != nullptr;
                     return known ? QString() : tr("No person has this name");
                   }));
    addField<Area>(source, "rate");
    addField<Area>(source, "from");
    FieldLook until;
    until.fallback = [](const Entity&) { return 86400.0; };
    addField<Area>(source, "until", until);
    FieldLook count;
    count.unit = tr("people");
    count.unitOfOne = tr("person");
    count.fallback = [](const Entity&) { return 100000.0; };
    addField<Area>(source, "count", count);
    addNewFields<Area>();
    addRefresh([source](const std::vector<Entity>& shown) {
      source->setVisible(std::all_of(shown.begin(), shown.end(), [](const Entity& each) {
        return std::get<Area>(each).kind == sim2d::AreaKind::Source;
      }));
    });
  }
};

}  // namespace

RobotPage::RobotPage(ScenarioDocument& document, const sim2d::FieldTables& tables,
                     const sim2d::Registries& registries)
    : PropertyPage(document, tables) {
  FormSection* section = addSection(tr("Robot"));
  addName(section);
  addListed(section);
  addField<Robot>(section, "type", oneOf(registries.robotTypes.names(), tr("generic (default)")));
  addField<Robot>(section, "planner", oneOf(registries.planners.names(), tr("pursuit (default)")));
  FieldLook command;
  command.visible = [](const std::vector<Entity>& shown) {
    return std::all_of(shown.begin(), shown.end(), [](const Entity& each) {
      return robotOf(each).planner == std::string(sim2d::kExternalPlanner) ||
             robotOf(each).command.has_value();
    });
  };
  addField<Robot>(section, "command", command);
  addParameterRows(section, plannersOf(registries),
                   tr("Parameters that the planner does not have or that are no numbers"));
  FormSection* start = addSection(tr("Start"));
  addPosition(start);
  addRow(start, headingField());
  addField<Robot>(start, "start_time");
  addGoalSection();
  FormSection* body = addSection(tr("Body and limits"));
  for (const char* key : {"radius", "mass", "max_vel", "max_acc", "max_omega", "max_alpha"}) {
    addField<Robot>(body, key);
  }
  addRow(body, footprintField(), emptyAs(tr("a disc of the radius"), footprintProblem));
  addField<Robot>(body, "kinematics",
                  inWords({tr("Two wheels"), tr("Every direction"), tr("Like a car")},
                          tr("As the type (default)")));
  addField<Robot>(body, "turning_radius");
  addFolded<sim2d::DetectorSettings>(
      tr("Knows of people"), tables,
      {{"kind", inWords({tr("What it sees"), tr("Everybody (ground truth)")}, tr("(default)"))},
       {"velocities", inWords({tr("As they are"), tr("From places")}, tr("(default)"))}});
  addFolded<sim2d::LidarSettings>(tr("Lidar"), tables);
  addFolded<sim2d::OdometrySettings>(tr("Errors of odometry"), tables);
  addNewFields<Robot>({"goals", "footprint_x", "footprint_y"});
}

/// A row per key of the table, folded: most people leave them as they are.
template <class Part>
void RobotPage::addFolded(const QString& title, const sim2d::FieldTables& tables,
                          const std::map<std::string, FieldLook>& looks) {
  FormSection* section = addSection(title);
  for (const sim2d::Field<Part>& field : sim2d::fieldsOf<Part>(tables)) {
    const auto look = looks.find(field.spec.key);
    addField<Part>(section, field.spec.key, look == looks.end() ? FieldLook() : look->second);
  }
  section->setOpen(false);
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

std::map<EntityKind, PropertyPage*> entityPages(ScenarioDocument& document, const Theme& theme) {
  return {{EntityKind::Human, new PersonPage(document, theme)},
          {EntityKind::Robot, new RobotPage(document)},
          {EntityKind::Goal, new GoalPage(document)},
          {EntityKind::Obstacle, new ObstaclePage(document)},
          {EntityKind::Door, new DoorPage(document)},
          {EntityKind::Area, new AreaPage(document)},
          {EntityKind::Scenario, new SettingsPage(document)}};
}

}  // namespace editor
