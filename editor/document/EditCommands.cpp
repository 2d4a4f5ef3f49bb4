#include "editor/document/EditCommands.h"

#include <algorithm>
#include <iterator>

#include "editor/document/EditDraft.h"
#include "editor/document/FreeNames.h"
#include "editor/document/Places.h"
#include "editor/document/RoutePlan.h"

namespace editor {

bool isListed(const Entity& entity) {
  return std::visit(
      [](const auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, sim2d::GlobalGoal> ||
                      std::is_same_v<Value, ScenarioSettings>) {
          return true;
        } else {
          return value.listed;
        }
      },
      entity);
}

namespace {

QString textFor(const QString& verb, const std::vector<Entity>& values) {
  if (values.size() == 1) {
    return QStringLiteral("%1 %2").arg(verb, displayName(values.front()));
  }
  return QStringLiteral("%1 %2 things").arg(verb).arg(values.size());
}

std::vector<Entity> valuesOf(const ScenarioDocument& document, const std::vector<EntityId>& ids) {
  std::vector<Entity> values;
  for (const EntityId id : ids) {
    if (std::optional<Entity> value = document.entity(id)) {
      values.push_back(*std::move(value));
    }
  }
  return values;
}

void dropGoal(Draft& draft, int goal) {
  draft.forEach<sim2d::Human>([goal](sim2d::Human& human) {
    auto& waits = human.ours.wait;
    for (std::size_t i = human.goals.size(); i-- > 0;) {
      if (human.goals[i] != goal) {
        continue;
      }
      human.goals.erase(human.goals.begin() + static_cast<std::ptrdiff_t>(i));
      if (i < waits.size()) {
        waits.erase(waits.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  });
  draft.forEach<sim2d::Robot>([goal](sim2d::Robot& robot) {
    auto& goals = robot.goal.goals;
    goals.erase(std::remove(goals.begin(), goals.end(), goal), goals.end());
  });
}

void renamePerson(Draft& draft, const std::string& from, const std::optional<std::string>& to) {
  draft.forEach<sim2d::Area>([&](sim2d::Area& area) {
    if (area.like == from) {
      area.like = to;
    }
  });
}

}  // namespace

void pushEdit(ScenarioDocument& document, std::vector<Entity> values, const QString& text,
              Merge merge) {
  Draft draft(document);
  Places places(document.scenario());
  for (Entity& value : values) {
    const std::optional<Entity> old = document.entity(idOf(value));
    if (!old) {
      continue;
    }
    const int index = isListed(*old) == isListed(value) ? -1 : places.ofSwitched(value);
    draft.set(std::move(value), index);
  }
  draft.push(document, text, merge);
}

std::vector<EntityId> pushAdd(ScenarioDocument& document, std::vector<Entity> values,
                              const QString& text) {
  FreeNames names(document.scenario());
  std::vector<EntityId> ids;
  std::vector<EntityEdit> edits;
  for (Entity& value : values) {
    const EntityId id = document.newId(kindOf(value));
    setId(value, id);
    names.give(value);
    ids.push_back(id);
  }
  const QString fullText = text.isEmpty() ? textFor(QStringLiteral("Add"), values) : text;
  Places places(document.scenario());
  for (Entity& value : values) {
    const int index = places.ofNew(value);
    const EntityId id = idOf(value);
    edits.push_back({id, {std::move(value), index}});
  }
  if (!edits.empty()) {
    document.undoStack().push(new EditEntity(document, std::move(edits), fullText));
  }
  return ids;
}

EntityId pushAdd(ScenarioDocument& document, Entity value) {
  return pushAdd(document, std::vector<Entity>{std::move(value)}, QString()).front();
}

void pushRemove(ScenarioDocument& document, const std::vector<EntityId>& ids) {
  Draft draft(document);
  const std::vector<Entity> values = valuesOf(document, ids);
  for (const Entity& value : values) {
    if (kindOf(value) != EntityKind::Scenario) {
      draft.remove(idOf(value));
    }
  }
  for (const Entity& value : values) {
    if (const auto* goal = std::get_if<sim2d::GlobalGoal>(&value)) {
      dropGoal(draft, goal->id);
    } else if (const auto* human = std::get_if<sim2d::Human>(&value)) {
      renamePerson(draft, human->name, std::nullopt);
    }
  }
  draft.push(document, textFor(QStringLiteral("Remove"), values));
}

void pushMove(ScenarioDocument& document, const std::vector<EntityId>& ids, const Vec2& delta,
              Merge merge) {
  std::vector<Entity> values = valuesOf(document, ids);
  const QString text = textFor(QStringLiteral("Move"), values);
  for (Entity& value : values) {
    value = moved(std::move(value), delta);
  }
  pushEdit(document, std::move(values), text, merge);
}

void pushTurn(ScenarioDocument& document, const std::vector<EntityId>& ids, double heading) {
  std::vector<Entity> values = valuesOf(document, ids);
  const QString text = textFor(QStringLiteral("Turn"), values);
  for (Entity& value : values) {
    value = turned(std::move(value), heading);
  }
  pushEdit(document, std::move(values), text);
}

std::vector<EntityId> pushDuplicate(ScenarioDocument& document, const std::vector<EntityId>& ids,
                                    const Vec2& delta) {
  std::vector<Entity> values = valuesOf(document, ids);
  values.erase(
      std::remove_if(values.begin(), values.end(),
                     [](const Entity& value) { return kindOf(value) == EntityKind::Scenario; }),
      values.end());
  if (values.empty()) {
    return {};
  }
  const QString text = textFor(QStringLiteral("Duplicate"), values);
  std::vector<std::optional<std::string>> trees;
  for (Entity& value : values) {
    trees.push_back(document.tree(idOf(value)));
    value = moved(std::move(value), delta, true);
  }
  document.undoStack().beginMacro(text);
  std::vector<EntityId> copies = pushAdd(document, std::move(values), text);
  std::vector<TreeEdit> edits;
  for (std::size_t i = 0; i < copies.size(); ++i) {
    if (trees[i]) {
      edits.push_back({copies[i], std::move(trees[i])});
    }
  }
  if (!edits.empty()) {
    document.undoStack().push(new EditTree(document, std::move(edits), text));
  }
  document.undoStack().endMacro();
  return copies;
}

bool pushRename(ScenarioDocument& document, EntityId id, const std::string& name) {
  std::optional<Entity> value = document.entity(id);
  if (!value || name.empty() || isNameTaken(document.scenario(), name)) {
    return false;
  }
  const std::string old = nameOf(*value);
  Draft draft(document);
  if (kindOf(*value) == EntityKind::Human) {
    renamePerson(draft, old, name);
  }
  setName(*value, name);
  draft.set(*std::move(value));
  draft.push(document, QStringLiteral("Rename %1").arg(QString::fromStdString(old)));
  return true;
}

bool pushGoalNumber(ScenarioDocument& document, EntityId id, int number) {
  const sim2d::GlobalGoal* goal = document.goal(id);
  if (goal == nullptr || number < 1 || document.scenario().goal(number) != nullptr) {
    return false;
  }
  const int old = goal->id;
  Draft draft(document);
  const auto renumber = [old, number](std::vector<int>& goals) {
    std::replace(goals.begin(), goals.end(), old, number);
  };
  draft.forEach<sim2d::Human>([&](sim2d::Human& human) { renumber(human.goals); });
  draft.forEach<sim2d::Robot>([&](sim2d::Robot& robot) { renumber(robot.goal.goals); });
  sim2d::GlobalGoal changed = *goal;
  changed.id = number;
  draft.set(changed);
  draft.push(document, QStringLiteral("Number goal %1").arg(old));
  return true;
}

void pushRoute(ScenarioDocument& document, const std::vector<EntityId>& humans,
               const std::vector<int>& goals) {
  std::vector<Entity> values;
  for (Entity& value : valuesOf(document, humans)) {
    if (auto* human = std::get_if<sim2d::Human>(&value)) {
      setGoals(*human, goals);
    } else if (auto* robot = std::get_if<sim2d::Robot>(&value)) {
      robot->goal.point.reset();
      robot->goal.goals = goals;
    } else {
      continue;
    }
    values.push_back(std::move(value));
  }
  const QString text = textFor(QStringLiteral("Route of"), values);
  pushEdit(document, std::move(values), text);
}

void pushReorder(ScenarioDocument& document, EntityId id, int index) {
  if (std::optional<Entity> value = document.entity(id)) {
    Draft draft(document);
    const QString text = textFor(QStringLiteral("Reorder"), {*value});
    draft.set(*std::move(value), index);
    draft.push(document, text);
  }
}

void pushReorder(ScenarioDocument& document, const std::vector<EntityId>& ids, int index) {
  if (ids.empty()) {
    return;
  }
  std::vector<EntityId> order = document.entities(ids.front().kind);
  const auto moves = [&ids](EntityId id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  std::vector<EntityId> moving;
  std::copy_if(order.begin(), order.end(), std::back_inserter(moving), moves);
  const auto place = order.begin() + std::clamp(index, 0, static_cast<int>(order.size()));
  const auto before = std::count_if(order.begin(), place, [&](EntityId id) { return !moves(id); });
  order.erase(std::remove_if(order.begin(), order.end(), moves), order.end());
  order.insert(order.begin() + before, moving.begin(), moving.end());
  std::stable_partition(order.begin(), order.end(),
                        [&document](EntityId id) { return isListed(*document.entity(id)); });
  Draft draft(document);
  for (std::size_t i = 0; i < order.size(); ++i) {  // in order, so that each lands in its place
    draft.set(*document.entity(order[i]), static_cast<int>(i));
  }
  draft.push(document, textFor(QStringLiteral("Reorder"), valuesOf(document, moving)));
}

void pushListed(ScenarioDocument& document, const std::vector<EntityId>& ids, bool listed) {
  std::vector<Entity> values = valuesOf(document, ids);
  const QString text =
      textFor(listed ? QStringLiteral("Switch on") : QStringLiteral("Switch off"), values);
  for (Entity& value : values) {
    std::visit(
        [listed](auto& each) {
          using Value = std::decay_t<decltype(each)>;
          if constexpr (!std::is_same_v<Value, sim2d::GlobalGoal> &&
                        !std::is_same_v<Value, ScenarioSettings>) {
            each.listed = listed;
          }
        },
        value);
  }
  pushEdit(document, std::move(values), text);
}

}  // namespace editor
