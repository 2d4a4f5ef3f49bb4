#include "editor/panels/EntityPages.h"

#include <algorithm>

#include "editor/panels/KeyAccess.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/world/World.h"

namespace editor {

namespace {

using sim2d::Area;
using sim2d::Door;
using sim2d::Obstacle;
using sim2d::ObstacleKind;
using sim2d::Robot;

constexpr NumberField::Range kLength = {0.01, 1000.0, 2, 0.1};
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

}  // namespace

QString listText(const std::vector<double>& values) {
  QStringList words;
  for (const double value : values) {
    words.push_back(QString::fromStdString(base::formatDouble(value)));
  }
  return words.join(QStringLiteral(", "));
}

std::optional<std::vector<double>> listFromText(const QString& text) {
  std::vector<double> values;
  for (const QString& word : text.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    const std::optional<double> value = base::parseDouble(word.trimmed().toStdString());
    if (!value) {
      return std::nullopt;
    }
    values.push_back(*value);
  }
  return values;
}

RobotPage::RobotPage(ScenarioDocument& document, QWidget* parent) : PropertyPage(document, parent) {
  FormSection* section = addSection(tr("Robot"));
  addName(section);
  addChoice(section, nameChoice(
                         tr("Type"), tr("generic (default)"), sim2d::robotTypeNames(),
                         [](Entity & e) -> auto& { return std::get<Robot>(e).type; }));
  addChoice(section, nameChoice(
                         tr("Planner"), tr("pursuit (default)"), sim2d::plannerNames(),
                         [](Entity & e) -> auto& { return std::get<Robot>(e).planner; }));
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
}

GoalPage::GoalPage(ScenarioDocument& document, QWidget* parent) : PropertyPage(document, parent) {
  FormSection* section = addSection(tr("Goal"));
  auto* number = new NumberField({1.0, 999999.0, 0, 1.0}, {}, this);
  section->addRow(tr("Number"), number);
  connect(number, &NumberField::edited, this, [this, number](double value) {
    if (targets().size() == 1 &&
        !pushGoalNumber(this->document(), targets().front(), static_cast<int>(value))) {
      refresh();
    }
  });
  addRefresh([number](const std::vector<Entity>& shown) {
    number->setEnabled(shown.size() == 1);
    number->show(std::get<sim2d::GlobalGoal>(shown.front()).id, false);
  });
  addNumberPair(section, tr("Position"), xKey(), yKey());
  auto* users = secondaryLabel({}, this);
  users->setWordWrap(true);
  section->addRow(tr("Visited by"), users);
  addRefresh([this, users](const std::vector<Entity>& shown) {
    QStringList names;
    const int id = std::get<sim2d::GlobalGoal>(shown.front()).id;
    for (const sim2d::Human& human : this->document().scenario().humans) {
      if (std::find(human.goals.begin(), human.goals.end(), id) != human.goals.end()) {
        names.push_back(QString::fromStdString(human.name));
      }
    }
    users->setText(names.isEmpty() ? tr("nobody yet") : names.join(QStringLiteral(", ")));
  });
  finish();
}

ObstaclePage::ObstaclePage(ScenarioDocument& document, QWidget* parent)
    : PropertyPage(document, parent) {
  section_ = addSection(tr("Obstacle"));
  addName(section_);
  addNumberPair(section_, tr("Position"), xKey(), yKey());
  const auto add = [this](const NumberKey& key, std::vector<ObstacleKind> of) {
    rows_.emplace_back(addNumber(section_, key), std::move(of));
  };
  add(headingKey(), {ObstacleKind::Box});
  add(numberKey(tr("Length"), tr("m"), kLength, &Obstacle::length), {ObstacleKind::Box});
  add(numberKey(tr("Width"), tr("m"), kLength, &Obstacle::width), {ObstacleKind::Box});
  add(numberKey(tr("Radius"), tr("m"), kLength, &Obstacle::radius), {ObstacleKind::Circle});
  add(numberKey(tr("Thickness"), tr("m"), {0.01, 5.0, 2, 0.05}, &Obstacle::thickness, 0.1),
      {ObstacleKind::Wall});
  finish();
}

void ObstaclePage::refresh() {
  PropertyPage::refresh();
  const std::vector<Entity> shown = values();
  if (shown.empty()) {
    return;
  }
  const Obstacle& obstacle = std::get<Obstacle>(shown.front());
  static const char* const kWords[] = {QT_TR_NOOP("box"), QT_TR_NOOP("circle"),
                                       QT_TR_NOOP("polygon"), QT_TR_NOOP("wall")};
  section_->setNote(tr(kWords[static_cast<std::size_t>(obstacle.kind)]));
  for (const auto& [field, kinds] : rows_) {
    const bool fits = std::find(kinds.begin(), kinds.end(), obstacle.kind) != kinds.end();
    section_->setRowVisible(field, fits);
  }
}

DoorPage::DoorPage(ScenarioDocument& document, QWidget* parent) : PropertyPage(document, parent) {
  FormSection* section = addSection(tr("Door"));
  addName(section);
  addNumberPair(section, tr("Position"), xKey(), yKey());
  addNumber(section,
            numberKey(tr("Thickness"), tr("m"), {0.01, 1.0, 2, 0.01}, &Door::thickness, 0.05));
  SwitchKey open;
  open.label = tr("At the start");
  open.words = tr("Open");
  open.get = [](const Entity& entity) { return std::get<Door>(entity).open.value_or(true); };
  open.set = [](Entity& entity, bool on) { std::get<Door>(entity).open = on; };
  addSwitch(section, open);
  TextKey toggles;
  toggles.label = tr("Changes at");
  toggles.placeholder = tr("seconds, such as 5, 12.5");
  toggles.hint = tr("It opens or closes at each of these times");
  toggles.get = [](const Entity& entity) { return listText(std::get<Door>(entity).toggles); };
  toggles.set = [](Entity& entity, const QString& text) {
    std::get<Door>(entity).toggles = listFromText(text).value_or(std::vector<double>());
  };
  toggles.check = [](const QString& text) {
    const auto times = listFromText(text);
    const bool fine = times && std::is_sorted(times->begin(), times->end()) &&
                      (times->empty() || times->front() >= 0.0);
    return fine ? QString() : tr("Times in seconds, ascending, with commas between them");
  };
  addText(section, toggles);
  finish();
}

AreaPage::AreaPage(ScenarioDocument& document, QWidget* parent) : PropertyPage(document, parent) {
  FormSection* section = addSection(tr("Area"));
  addName(section);
  ChoiceKey kind;
  kind.label = tr("Kind");
  kind.words = QStringList{tr("Source: people come in"), tr("Sink: people leave"),
                           tr("Waiting area"), tr("Exit")};
  kind.get = [](const Entity& entity) { return static_cast<int>(std::get<Area>(entity).kind); };
  kind.set = [](Entity& entity, int index) {
    std::get<Area>(entity).kind = static_cast<sim2d::AreaKind>(index);
  };
  addChoice(section, kind);
  addNumberPair(section, tr("Position"), xKey(), yKey());
  source_ = addSection(tr("Who comes in"));
  TextKey like;
  like.label = tr("Like");
  like.placeholder = tr("name of a person");
  like.get = [](const Entity& entity) {
    return QString::fromStdString(std::get<Area>(entity).like.value_or(std::string()));
  };
  like.set = [](Entity& entity, const QString& text) {
    std::get<Area>(entity).like = text.isEmpty() ? std::nullopt : std::optional(text.toStdString());
  };
  like.check = [this](const QString& text) {
    const bool known =
        text.isEmpty() || this->document().scenario().human(text.toStdString()) != nullptr;
    return known ? QString() : tr("No person has this name");
  };
  addText(source_, like);
  addNumber(source_, numberKey(tr("Rate"), tr("/s"), {0.0, 50.0, 3, 0.05}, &Area::rate, 0.0));
  addNumber(source_, numberKey(tr("From"), tr("s"), kTime, &Area::from, 0.0));
  addNumber(source_, numberKey(tr("Until"), tr("s"), kTime, &Area::until, 86400.0));
  addNumber(source_, placedKey(
                         tr("At most"), tr("people"), {0.0, 100000.0, 0, 1.0}, 100000.0,
                         [](Entity & e) -> auto& { return std::get<Area>(e).count; }));
  finish();
}

void AreaPage::refresh() {
  PropertyPage::refresh();
  const std::vector<Entity> shown = values();
  source_->setVisible(!shown.empty() &&
                      std::get<Area>(shown.front()).kind == sim2d::AreaKind::Source);
}

}  // namespace editor
