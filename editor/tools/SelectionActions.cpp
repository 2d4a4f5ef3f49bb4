#include "editor/tools/SelectionActions.h"

#include "editor/document/EditCommands.h"

namespace editor {

void duplicateSelection(ScenarioDocument& document) {
  document.setSelection(pushDuplicate(document, document.selection(), Vec2(0.8, -0.8)));
}

void selectAll(ScenarioDocument& document) {
  std::vector<EntityId> all;
  forEachList(document.scenario(), [&all](EntityKind /*kind*/, const auto& list) {
    for (const auto& value : list) {
      all.push_back(value.key);
    }
  });
  document.setSelection(std::move(all));
}

namespace {

struct Piece {
  Entity value;
  Extent extent;
};

std::vector<Piece> piecesOf(const ScenarioDocument& document) {
  std::vector<Piece> pieces;
  for (Entity& value : valuesOf(document, document.selection())) {
    if (const std::optional<Extent> extent = extentOf(value)) {
      pieces.push_back({std::move(value), *extent});
    }
  }
  return pieces;
}

Extent wholeOf(const std::vector<Piece>& pieces) {
  std::vector<Vec2> corners;
  for (const Piece& piece : pieces) {
    corners.insert(corners.end(), {piece.extent.low, piece.extent.high});
  }
  return *extentOf(corners);
}

/// The corner or centre by which bounding boxes are aligned.
Vec2 placeOf(const Extent& extent, Align how) {
  if (how == Align::CentreX || how == Align::CentreY) {
    return extent.centre();
  }
  return how == Align::Right || how == Align::Top ? extent.high : extent.low;
}

}  // namespace

void alignSelection(ScenarioDocument& document, Align how) {
  const std::vector<Piece> pieces = piecesOf(document);
  if (pieces.size() < 2) {
    return;
  }
  const Extent whole = wholeOf(pieces);
  std::vector<Entity> values;
  for (const Piece& piece : pieces) {
    Vec2 offset = placeOf(whole, how) - placeOf(piece.extent, how);
    offset(how < Align::Top ? 1 : 0) = 0.0;  // Along one axis.
    values.push_back(moved(piece.value, offset));
  }
  pushEdit(document, std::move(values), QObject::tr("Align"));
}

void distributeSelection(ScenarioDocument& document, Distribute how) {
  std::vector<Piece> pieces = piecesOf(document);
  if (pieces.size() < 3) {
    return;
  }
  const int axis = how == Distribute::Across ? 0 : 1;
  std::stable_sort(pieces.begin(), pieces.end(), [axis](const Piece& a, const Piece& b) {
    return a.extent.centre()(axis) < b.extent.centre()(axis);
  });
  const Extent whole = wholeOf(pieces);
  double room = whole.high(axis) - whole.low(axis);
  for (const Piece& piece : pieces) {
    room -= piece.extent.high(axis) - piece.extent.low(axis);
  }
  const double gap = room / double(pieces.size() - 1);
  std::vector<Entity> values;
  double at = whole.low(axis);
  for (const Piece& piece : pieces) {
    Vec2 offset = Vec2::Zero();
    offset(axis) = at - piece.extent.low(axis);
    at += piece.extent.high(axis) - piece.extent.low(axis) + gap;
    values.push_back(moved(piece.value, offset));
  }
  pushEdit(document, std::move(values), QObject::tr("Distribute"));
}

void rotateSelection(ScenarioDocument& document, double angle) {
  const std::vector<Piece> pieces = piecesOf(document);
  if (pieces.empty()) {
    return;
  }
  const Vec2 centre = wholeOf(pieces).centre();
  std::vector<Entity> values;
  values.reserve(pieces.size());
  for (const Piece& piece : pieces) {
    values.push_back(rotated(piece.value, centre, angle));
  }
  pushEdit(document, std::move(values), QObject::tr("Rotate"));
}

namespace {

constexpr const char* kTrees = "application/x-hunavsim-trees";
/// A comment in the text that lists goals included only because of routes.
constexpr const char* kAlong = "# goals along: ";
constexpr const char* kCopyHead = "# copied from HuNavSim Desktop\n";

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
  forEachList(document.scenario(), [&](EntityKind /*kind*/, const auto& list) {
    for (const auto& value : list) {
      if (document.isSelected(value.key)) {
        listOf<std::decay_t<decltype(value)>>(copied).push_back(value);
      }
    }
  });
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

/// Replaces names and numbers that are taken before the command does, so that references can be
/// updated.
struct Renaming {
  Renaming(const ScenarioDocument& document, const Vec2& shift, QJsonObject treesOfNames)
      : present(document.scenario()),
        names(document.scenario()),
        delta(shift),
        trees(std::move(treesOfNames)) {}

  void takeGoals(const sim2d::Scenario& copied, const std::set<int>& along) {
    for (const sim2d::GlobalGoal& goal : copied.goals) {
      const bool isAlong = along.count(goal.id) > 0;
      const sim2d::GlobalGoal* same = present.goal(goal.id);
      if (isAlong && same != nullptr && same->position == goal.position) {
        goals[goal.id] = goal.id;
      } else {
        add(moved(goal, isAlong ? Vec2(Vec2::Zero()) : delta), !isAlong);
        goals[goal.id] = std::get<sim2d::GlobalGoal>(values.back()).id;
      }
    }
  }

  void takePeople(const sim2d::Scenario& copied) {
    for (sim2d::Human human : copied.humans) {
      const QString old = QString::fromStdString(human.name);
      follow(human.goals);
      // A number from another scenario would leave a gap.
      human.id = std::min(human.id, names.nextHuman());
      add(moved(human, delta));
      people[old.toStdString()] = nameOf(values.back());
      if (trees.contains(old)) {
        own[values.size() - 1] = trees[old].toString().toStdString();
      }
    }
  }

  void takeRest(const sim2d::Scenario& copied) {
    for (sim2d::Robot robot : copied.robots) {
      follow(robot.goal.goals);
      add(moved(robot, delta, true));
    }
    for (const sim2d::Obstacle& obstacle : copied.obstacles) {
      add(moved(obstacle, delta));
    }
    for (const sim2d::Door& door : copied.doors) {
      add(moved(door, delta));
    }
    for (sim2d::Area area : copied.areas) {
      if (area.like && people.count(*area.like) > 0) {
        area.like = people.at(*area.like);
      }
      add(moved(area, delta));
    }
    for (const sim2d::Dock& dock : copied.docks) {
      add(moved(dock, delta));
    }
  }

  void add(Entity value, bool isChosen = true) {
    names.assignTo(value);
    if (isChosen) {
      chosen.push_back(values.size());
    }
    values.push_back(std::move(value));
  }
  void follow(std::vector<int>& route) const {
    for (int& goal : route) {
      const auto found = goals.find(goal);
      goal = found == goals.end() ? goal : found->second;
    }
  }

  const sim2d::Scenario& present;
  UniqueNames names;
  Vec2 delta;
  std::vector<Entity> values;
  std::vector<std::size_t> chosen;         // Indices of the values to be selected.
  QJsonObject trees;                       // Custom trees by names in the text.
  std::map<std::size_t, std::string> own;  // Custom trees by index of the values.
  std::map<int, int> goals;
  std::map<std::string, std::string> people;
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
  QString text = QLatin1String(kCopyHead);
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

namespace {

constexpr double kPasteStep = 0.5;     // [m]
constexpr int kMaxSteps = 200;         // A free position is found earlier in any real scenario.
constexpr double kSamePosition = 0.1;  // Closer entities hide each other [m].
constexpr double kBody = 0.35;         // Radius of a body if none is set [m].

/// None if the data contains no readable scenario.
std::optional<sim2d::Scenario> copiedScenario(const QMimeData& data) {
  if (!canPaste(&data)) {
    return std::nullopt;
  }
  sim2d::ScenarioReading reading = sim2d::readScenarioText(data.text().toStdString(), "clipboard");
  return reading.ok() ? std::optional(std::move(reading.scenario)) : std::nullopt;
}

/// The copied entities that paste moves.
std::vector<Entity> movedEntities(const sim2d::Scenario& copied, const std::set<int>& along) {
  std::vector<Entity> all;
  forEachList(copied, [&](EntityKind /*kind*/, const auto& list) {
    for (const auto& value : list) {
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, sim2d::GlobalGoal>) {
        if (along.count(value.id) > 0) {
          continue;
        }
      }
      all.emplace_back(value);
    }
  });
  return all;
}

double bodyOf(const Entity& entity) {
  const auto* human = std::get_if<sim2d::Human>(&entity);
  return human != nullptr                               ? human->radius.value_or(kBody)
         : std::holds_alternative<sim2d::Robot>(entity) ? kBody
                                                        : 0.5 * kSamePosition;
}

bool isOccupied(const ScenarioDocument& document, const Entity& entity, const Vec2& delta) {
  const Vec2 at = *positionOf(entity) + delta;
  for (const Entity& there : valuesOf(document, document.entities(kindOf(entity)))) {
    if ((*positionOf(there) - at).norm() < bodyOf(there) + bodyOf(entity)) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool pasteAt(ScenarioDocument& document, const QMimeData& data, const std::optional<Vec2>& centre) {
  const std::optional<sim2d::Scenario> copied = copiedScenario(data);
  if (!copied) {
    return false;
  }
  const std::vector<Entity> moving = movedEntities(*copied, goalsAlong(data.text()));
  std::vector<Vec2> corners;
  for (const Entity& entity : moving) {
    const std::optional<Extent> extent = extentOf(entity);
    corners.insert(corners.end(), {extent->low, extent->high});
  }
  const std::optional<Extent> whole = extentOf(corners);
  Vec2 delta = Vec2::Zero();
  if (centre && whole) {
    delta = rounded(((*centre - whole->centre()) * 100.0).array().round().matrix() / 100.0);
  }
  const auto isTaken = [&](const Entity& entity) { return isOccupied(document, entity, delta); };
  for (int i = 0; i < kMaxSteps && std::any_of(moving.begin(), moving.end(), isTaken); ++i) {
    delta += Vec2(kPasteStep, -kPasteStep);
  }
  return paste(document, data, delta);
}

bool paste(ScenarioDocument& document, const QMimeData& data, const Vec2& delta) {
  const std::optional<sim2d::Scenario> copied = copiedScenario(data);
  if (!copied) {
    return false;
  }
  Renaming renaming(document, delta,
                    QJsonDocument::fromJson(data.data(QLatin1String(kTrees))).object());
  renaming.takeGoals(*copied, goalsAlong(data.text()));
  renaming.takePeople(*copied);
  renaming.takeRest(*copied);
  if (renaming.values.empty()) {
    return false;
  }
  const std::vector<EntityId> ids =
      pushAdd(document, renaming.values, QObject::tr("Paste"), renaming.own);
  std::vector<EntityId> chosen;
  for (const std::size_t place : renaming.chosen) {
    chosen.push_back(ids[place]);
  }
  document.setSelection(std::move(chosen));
  return true;
}

}  // namespace editor
