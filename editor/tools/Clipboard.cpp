#include "editor/tools/Clipboard.h"

#include <algorithm>
#include <map>
#include <set>

#include <QJsonDocument>
#include <QJsonObject>

#include "editor/document/EditCommands.h"
#include "editor/document/EntityLists.h"
#include "editor/document/FreeNames.h"
#include "editor/document/Geometry.h"

namespace editor {

namespace {

constexpr const char* kTrees = "application/x-hunavsim-trees";
/// A comment in the text: goals that came along for the sake of routes.
constexpr const char* kAlong = "# goals along: ";
constexpr const char* kHead = "# copied from HuNavSim Desktop\n";

void addRoute(sim2d::Scenario& copied, const sim2d::Scenario& all, const std::vector<int>& goals,
              QStringList& along) {
  for (const int id : goals) {
    const sim2d::GlobalGoal* goal = all.goal(id);
    if (goal != nullptr && copied.goal(id) == nullptr) {
      copied.goals.push_back(*goal);
      along << QString::number(id);
    }
  }
}

sim2d::Scenario selected(const ScenarioDocument& document) {
  sim2d::Scenario copied;
  for (const EntityKind kind : {EntityKind::Goal, EntityKind::Human, EntityKind::Robot,
                                EntityKind::Obstacle, EntityKind::Door, EntityKind::Area}) {
    for (const EntityId id : document.entities(kind)) {
      if (document.isSelected(id)) {
        const Entity value = *document.entity(id);
        withList(
            copied, kind,
            [&](auto& list) {
              using Value = typename std::decay_t<decltype(list)>::value_type;
              list.push_back(std::get<Value>(value));
              return true;
            },
            false);
      }
    }
  }
  return copied;
}

std::set<int> goalsAlong(const QString& text) {
  std::set<int> ids;
  for (const QString& line : text.split(QLatin1Char('\n'))) {
    if (line.startsWith(QLatin1String(kAlong))) {
      const QString words = line.mid(static_cast<int>(qstrlen(kAlong)));
      for (const QString& word : words.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        ids.insert(word.toInt());
      }
    }
  }
  return ids;
}

/// Makes names and numbers free in the document before the command does, so that what names others
/// can follow.
class Renaming {
 public:
  Renaming(const ScenarioDocument& document, const Vec2& delta)
      : document_(document), names_(document.scenario()), delta_(delta) {}

  void takeGoals(const sim2d::Scenario& copied, const std::set<int>& along) {
    for (const sim2d::GlobalGoal& goal : copied.goals) {
      const sim2d::GlobalGoal* same = document_.scenario().goal(goal.id);
      if (along.count(goal.id) > 0 && same != nullptr && same->position == goal.position) {
        goals_[goal.id] = goal.id;
      } else {
        Entity value = moved(goal, along.count(goal.id) > 0 ? Vec2(Vec2::Zero()) : delta_);
        names_.give(value);
        goals_[goal.id] = std::get<sim2d::GlobalGoal>(value).id;
        isChosen_.push_back(along.count(goal.id) == 0);
        values_.push_back(std::move(value));
      }
    }
  }
  void takePeople(const sim2d::Scenario& copied) {
    for (sim2d::Human human : copied.humans) {
      const std::string old = human.name;
      follow(human.goals);
      // A number of another scenario would leave a gap before it.
      human.id = std::min(human.id, names_.nextHuman());
      takeMoved(human);
      people_[old] = nameOf(values_.back());
      treeOwners_.push_back(old);
    }
  }
  void takeRest(const sim2d::Scenario& copied) {
    for (sim2d::Robot robot : copied.robots) {
      follow(robot.goal.goals);
      takeMoved(robot);
    }
    for (const sim2d::Obstacle& obstacle : copied.obstacles) {
      takeMoved(obstacle);
    }
    for (const sim2d::Door& door : copied.doors) {
      takeMoved(door);
    }
    for (sim2d::Area area : copied.areas) {
      if (area.like && people_.count(*area.like) > 0) {
        area.like = people_.at(*area.like);
      }
      takeMoved(area);
    }
  }

  const std::vector<Entity>& values() const { return values_; }
  bool isChosen(std::size_t index) const { return isChosen_[index]; }
  /// Names in the text of the people, in the order of their values.
  const std::vector<std::string>& treeOwners() const { return treeOwners_; }

 private:
  void takeMoved(Entity value) {
    value = moved(std::move(value), delta_, true);
    names_.give(value);
    isChosen_.push_back(true);
    values_.push_back(std::move(value));
  }
  void follow(std::vector<int>& route) const {
    for (int& goal : route) {
      const auto found = goals_.find(goal);
      goal = found == goals_.end() ? goal : found->second;
    }
  }

  const ScenarioDocument& document_;
  FreeNames names_;
  Vec2 delta_;
  std::vector<Entity> values_;
  std::vector<bool> isChosen_;  // beside the values: to be selected
  std::vector<std::string> treeOwners_;
  std::map<int, int> goals_;
  std::map<std::string, std::string> people_;
};

}  // namespace

std::unique_ptr<QMimeData> copiedSelection(const ScenarioDocument& document) {
  sim2d::Scenario copied = selected(document);
  QStringList along;
  for (const sim2d::Human& human : copied.humans) {
    addRoute(copied, document.scenario(), human.goals, along);
  }
  for (const sim2d::Robot& robot : copied.robots) {
    addRoute(copied, document.scenario(), robot.goal.goals, along);
  }
  QString text = QLatin1String(kHead);
  if (!along.empty()) {
    text += QLatin1String(kAlong) + along.join(QLatin1Char(' ')) + QLatin1Char('\n');
  }
  QJsonObject trees;
  for (const sim2d::Human& human : copied.humans) {
    if (const std::optional<std::string> xml = document.tree(human.key)) {
      trees[QString::fromStdString(human.name)] = QString::fromStdString(*xml);
    }
  }
  auto data = std::make_unique<QMimeData>();
  data->setText(text + QString::fromStdString(sim2d::writeScenario(copied)));
  if (!trees.isEmpty()) {
    data->setData(QLatin1String(kTrees), QJsonDocument(trees).toJson(QJsonDocument::Compact));
  }
  return data;
}

bool canPaste(const QMimeData* data) {
  return data != nullptr && data->hasText() &&
         data->text().contains(QLatin1String("hunav_loader:"));
}

bool paste(ScenarioDocument& document, const QMimeData& data, const Vec2& delta) {
  if (!canPaste(&data)) {
    return false;
  }
  const sim2d::ScenarioReading reading =
      sim2d::readScenarioText(data.text().toStdString(), "clipboard");
  if (!reading.ok()) {
    return false;
  }
  Renaming renaming(document, delta);
  renaming.takeGoals(reading.scenario, goalsAlong(data.text()));
  renaming.takePeople(reading.scenario);
  renaming.takeRest(reading.scenario);
  if (renaming.values().empty()) {
    return false;
  }
  const QJsonObject trees = QJsonDocument::fromJson(data.data(QLatin1String(kTrees))).object();
  const QString text = QObject::tr("Paste");
  document.undoStack().beginMacro(text);
  const std::vector<EntityId> ids = pushAdd(document, renaming.values(), text);
  std::vector<EntityId> chosen;
  std::vector<TreeEdit> edits;
  std::size_t person = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (renaming.isChosen(i)) {
      chosen.push_back(ids[i]);
    }
    if (ids[i].kind == EntityKind::Human) {
      const QString owner = QString::fromStdString(renaming.treeOwners()[person++]);
      if (trees.contains(owner)) {
        edits.push_back({ids[i], trees[owner].toString().toStdString()});
      }
    }
  }
  if (!edits.empty()) {
    document.undoStack().push(new EditTree(document, std::move(edits), text));
  }
  document.undoStack().endMacro();
  document.setSelection(std::move(chosen));
  return true;
}

}  // namespace editor
