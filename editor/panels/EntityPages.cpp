#include "editor/panels/EntityPages.h"

#include <algorithm>
#include <utility>

namespace editor {

namespace {

using sim2d::Area;
using sim2d::Dock;
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

class DockPage : public PropertyPage {
 public:
  explicit DockPage(ScenarioDocument& document) : PropertyPage(document) {
    FormSection* section = addSection(tr("Dock"));
    addName(section);
    addListed(section);
    addField<Dock>(section, "kind", inWords({tr("Charges robots"), tr("Parking place")}));
    addPosition(section);
    addRow(section, headingField(), {});
    addNewFields<Dock>({"x", "y", "h"});
  }
};

}  // namespace

std::map<EntityKind, PropertyPage*> entityPages(ScenarioDocument& document, const Theme& theme) {
  auto* const robot = new RobotPage(document);
  robot->setTheme(theme);
  return {{EntityKind::Human, new PersonPage(document, theme)},
          {EntityKind::Robot, robot},
          {EntityKind::Goal, new GoalPage(document)},
          {EntityKind::Obstacle, new ObstaclePage(document)},
          {EntityKind::Door, new DoorPage(document)},
          {EntityKind::Area, new AreaPage(document)},
          {EntityKind::Dock, new DockPage(document)},
          {EntityKind::Scenario, new SettingsPage(document)}};
}

}  // namespace editor
