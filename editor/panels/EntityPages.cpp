#include "editor/panels/EntityPages.h"

#include <algorithm>

#include "editor/panels/KeyAccess.h"

namespace editor {

namespace {

using sim2d::Area;
using sim2d::Door;
using sim2d::Obstacle;
using sim2d::ObstacleKind;

constexpr NumberField::Range kLength = {0.01, 1000.0, 2, 0.1};
constexpr int kMostVisitors = 12;  // by name
constexpr NumberField::Range kTime = {0.0, 86400.0, 1, 1.0};

/// The corners of a shape as text; `least` of them make one.
template <class T>
TextKey cornersKey(std::size_t least) {
  TextKey key;
  key.label = QObject::tr("Corners");
  key.hint = QObject::tr("x y [m], with semicolons between them");
  key.get = [](const Entity& entity) { return pointsText(std::get<T>(entity).points); };
  key.set = [](Entity& entity, const QString& text) {
    std::get<T>(entity).points = *pointsFromText(text);
  };
  key.check = [least](const QString& text) {
    const auto corners = pointsFromText(text);
    return corners && corners->size() >= least
               ? QString()
               : QObject::tr("At least %1 corners x y, with semicolons between them").arg(least);
  };
  return key;
}

}  // namespace

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
    if (shown.size() == 1) {
      number->show(std::get<sim2d::GlobalGoal>(shown.front()).id, false);
    } else {
      number->showMixed();
    }
  });
  addNumberPair(section, tr("Position"), xKey(), yKey());
  auto* users = secondaryLabel({}, this);
  users->setWordWrap(true);
  section->addRow(tr("Visited by"), users);
  addRefresh([this, users](const std::vector<Entity>& shown) {
    users->setText(shown.size() == 1 ? visitorsOf(std::get<sim2d::GlobalGoal>(shown.front()).id)
                                     : tr("several goals are selected"));
  });
  finish();
}

QString GoalPage::visitorsOf(int goal) const {
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

ObstaclePage::ObstaclePage(ScenarioDocument& document, QWidget* parent)
    : PropertyPage(document, parent) {
  section_ = addSection(tr("Obstacle"));
  addName(section_);
  addSwitch(section_, listedKey());
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
  rows_.emplace_back(addText(section_, cornersKey<Obstacle>(2)),
                     std::vector{ObstacleKind::Polygon, ObstacleKind::Wall});
  finish();
}

void ObstaclePage::refresh() {
  PropertyPage::refresh();
  const std::vector<Entity> shown = values();
  if (shown.empty()) {
    return;
  }
  const ObstacleKind first = std::get<Obstacle>(shown.front()).kind;
  const auto all = [&shown](const auto& holds) {
    return std::all_of(shown.begin(), shown.end(),
                       [&](const Entity& each) { return holds(std::get<Obstacle>(each).kind); });
  };
  static const char* const kWords[] = {QT_TR_NOOP("box"), QT_TR_NOOP("circle"),
                                       QT_TR_NOOP("polygon"), QT_TR_NOOP("wall")};
  const bool isOneKind = all([first](ObstacleKind kind) { return kind == first; });
  section_->setNote(isOneKind ? tr(kWords[static_cast<std::size_t>(first)]) : tr("several shapes"));
  for (const auto& [field, kinds] : rows_) {
    section_->setRowVisible(field, all([&of = kinds](ObstacleKind kind) {
                              return std::find(of.begin(), of.end(), kind) != of.end();
                            }));
  }
}

DoorPage::DoorPage(ScenarioDocument& document, QWidget* parent) : PropertyPage(document, parent) {
  FormSection* section = addSection(tr("Door"));
  addName(section);
  addSwitch(section, listedKey());
  const auto end = [](const QString& label, Vec2 Door::*place, int axis) {
    NumberKey key = xKey();
    key.label = label;
    key.get = [place, axis](const Entity& entity) {
      return std::optional((std::get<Door>(entity).*place)(axis));
    };
    key.set = [place, axis](Entity& entity, std::optional<double> value) {
      Vec2& point = std::get<Door>(entity).*place;
      point(axis) = value.value_or(point(axis));
    };
    return key;
  };
  addNumberPair(section, tr("From"), end(tr("From X"), &Door::from, 0),
                end(tr("From Y"), &Door::from, 1));
  addNumberPair(section, tr("To"), end(tr("To X"), &Door::to, 0), end(tr("To Y"), &Door::to, 1));
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
  addSwitch(section, listedKey());
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
  addText(section, cornersKey<Area>(3));
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
  NumberKey count = placedKey(
      tr("At most"), tr("people"), {0.0, 100000.0, 0, 1.0}, 100000.0,
      [](Entity & e) -> auto& { return std::get<Area>(e).count; });
  count.unitOfOne = tr("person");
  addNumber(source_, count);
  finish();
}

void AreaPage::refresh() {
  PropertyPage::refresh();
  const std::vector<Entity> shown = values();
  source_->setVisible(!shown.empty() &&
                      std::all_of(shown.begin(), shown.end(), [](const Entity& each) {
                        return std::get<Area>(each).kind == sim2d::AreaKind::Source;
                      }));
}

}  // namespace editor
