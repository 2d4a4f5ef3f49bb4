#include "editor/document/EditCommands.h"

#include <algorithm>
#include <iterator>

#include "editor/document/EditDraft.h"
#include "editor/document/FreeNames.h"
#include "editor/document/RoutePlan.h"

namespace editor {

bool isListed(const Entity& entity) {
  return std::visit(
      [](const auto& value) {
        if constexpr (kIsNamed<std::decay_t<decltype(value)>>) {
          return value.listed;
        } else {
          return true;
        }
      },
      entity);
}

namespace {

constexpr int kEditEntity = 1;

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

/// What `change` makes of each, in one step.
template <class Change>
void pushEach(ScenarioDocument& document, const std::vector<EntityId>& ids, const QString& verb,
              Merge merge, Change&& change) {
  std::vector<Entity> values = valuesOf(document, ids);
  const QString text = textFor(verb, values);
  for (Entity& value : values) {
    value = change(std::move(value));
  }
  pushEdit(document, std::move(values), text, merge);
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

EditEntity::EditEntity(ScenarioDocument& document, std::vector<EntityEdit> edits,
                       const QString& text, Merge merge)
    : QUndoCommand(text), document_(document), edits_(std::move(edits)), merge_(merge) {}

void EditEntity::redo() {
  const ScenarioDocument::Step step(document_);
  for (EntityEdit& edit : edits_) {
    edit.slot = document_.exchange(edit.entity, std::move(edit.slot));
  }
}

void EditEntity::undo() {
  const ScenarioDocument::Step step(document_);
  for (auto edit = edits_.rbegin(); edit != edits_.rend(); ++edit) {
    edit->slot = document_.exchange(edit->entity, std::move(edit->slot));
  }
}

int EditEntity::id() const {
  return merge_ == Merge::WithPrevious ? kEditEntity : -1;
}

bool EditEntity::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const EditEntity*>(other);
  const bool same =
      next->text() == text() &&
      std::equal(edits_.begin(), edits_.end(), next->edits_.begin(), next->edits_.end(),
                 [](const EntityEdit& a, const EntityEdit& b) { return a.entity == b.entity; });
  if (!same) {
    return false;
  }
  // What is kept here are the values before the first of the merged edits.
  setObsolete(std::all_of(edits_.begin(), edits_.end(), [this](const EntityEdit& edit) {
    return edit.slot.value == document_.entity(edit.entity);
  }));
  return true;
}

EditTree::EditTree(ScenarioDocument& document, std::vector<TreeEdit> edits, const QString& text)
    : QUndoCommand(text), document_(document), edits_(std::move(edits)) {}

EditTree::EditTree(ScenarioDocument& document, EntityId human, std::optional<std::string> xml,
                   const QString& text)
    : EditTree(document, {{human, std::move(xml)}}, text) {}

void EditTree::swap() {
  const ScenarioDocument::Step step(document_);
  for (TreeEdit& edit : edits_) {
    edit.xml = document_.exchangeTree(edit.human, std::move(edit.xml));
  }
}

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
  pushEach(document, ids, QStringLiteral("Move"), merge,
           [&delta](Entity value) { return moved(std::move(value), delta); });
}

void pushTurn(ScenarioDocument& document, const std::vector<EntityId>& ids, double heading) {
  pushEach(document, ids, QStringLiteral("Turn"), Merge::Never,
           [heading](Entity value) { return turned(std::move(value), heading); });
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
  const QString verb = listed ? QStringLiteral("Switch on") : QStringLiteral("Switch off");
  pushEach(document, ids, verb, Merge::Never, [listed](Entity value) {
    std::visit(
        [listed](auto& each) {
          if constexpr (kIsNamed<std::decay_t<decltype(each)>>) {
            each.listed = listed;
          }
        },
        value);
    return value;
  });
}

}  // namespace editor
