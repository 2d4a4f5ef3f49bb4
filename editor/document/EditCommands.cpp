#include "editor/document/EditCommands.h"

#include <iterator>

#include "editor/document/PeopleEdits.h"
#include "editor/document/PersonTree.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

constexpr int kEditEntity = 1;

/// The single command type: redo and undo exchange values and trees with the document. Entities are
/// exchanged in order by redo and in reverse order by undo. A direction that removes selected
/// entities stores the selection, and the opposite direction restores it. A command whose merged
/// edits cancel out becomes obsolete.
class EditEntities : public QUndoCommand {
 public:
  EditEntities(ScenarioDocument& document, std::vector<EntityEdit> edits,
               std::vector<TreeEdit> trees, const QString& text, Merge merge)
      : QUndoCommand(text),
        document_(document),
        edits_(std::move(edits)),
        trees_(std::move(trees)),
        mayMerge_(merge == Merge::WithPrevious && trees_.empty()) {}

  void redo() override {
    const ScenarioDocument::Step step(document_);
    const std::vector<EntityId> before = document_.selection();
    std::for_each(edits_.begin(), edits_.end(), [this](EntityEdit& edit) { swap(edit); });
    swapTrees();
    restoreSelection(before);
  }

  void undo() override {
    const ScenarioDocument::Step step(document_);
    const std::vector<EntityId> before = document_.selection();
    std::for_each(edits_.rbegin(), edits_.rend(), [this](EntityEdit& edit) { swap(edit); });
    swapTrees();  // After the values: the document records for which person a tree is written.
    restoreSelection(before);
  }

  int id() const override { return mayMerge_ ? kEditEntity : -1; }

  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const EditEntities*>(other);
    const bool same =
        next->text() == text() &&
        std::equal(edits_.begin(), edits_.end(), next->edits_.begin(), next->edits_.end(),
                   [](const EntityEdit& a, const EntityEdit& b) { return a.entity == b.entity; });
    if (same) {  // The values stored here precede the first of the merged edits.
      setObsolete(std::all_of(edits_.begin(), edits_.end(), [this](const EntityEdit& edit) {
        return edit.slot.value == document_.entity(edit.entity);
      }));
    }
    return same;
  }

 private:
  void swap(EntityEdit& edit) { edit.slot = document_.exchange(edit.entity, std::move(edit.slot)); }
  /// `before`: the selection before the exchange.
  void restoreSelection(const std::vector<EntityId>& before) {
    const std::vector<EntityId> lost = std::exchange(lostSelection_, {});
    if (document_.selection().size() < before.size()) {
      lostSelection_ = before;
    } else if (!lost.empty()) {
      document_.setSelection(lost);
    }
  }
  void swapTrees() {
    for (TreeEdit& edit : trees_) {
      edit.xml = document_.exchangeTree(edit.human, std::move(edit.xml));
    }
  }

  ScenarioDocument& document_;
  std::vector<EntityEdit> edits_;
  std::vector<TreeEdit> trees_;
  std::vector<EntityId> lostSelection_;  // The selection that the last exchange reduced.
  bool mayMerge_;
};

/// What a command does to one and to several items, for the undo text.
struct CommandText {
  const char* one;
  const char* many;
};

constexpr CommandText kAddText = {QT_TRANSLATE_NOOP("EditCommand", "Add %1"),
                                  QT_TRANSLATE_NOOP("EditCommand", "Add %1 items")};
constexpr CommandText kRemoveText = {QT_TRANSLATE_NOOP("EditCommand", "Remove %1"),
                                     QT_TRANSLATE_NOOP("EditCommand", "Remove %1 items")};
constexpr CommandText kMoveText = {QT_TRANSLATE_NOOP("EditCommand", "Move %1"),
                                   QT_TRANSLATE_NOOP("EditCommand", "Move %1 items")};
constexpr CommandText kDuplicateText = {QT_TRANSLATE_NOOP("EditCommand", "Duplicate %1"),
                                        QT_TRANSLATE_NOOP("EditCommand", "Duplicate %1 items")};
constexpr CommandText kRouteText = {QT_TRANSLATE_NOOP("EditCommand", "Set route of %1"),
                                    QT_TRANSLATE_NOOP("EditCommand", "Set route of %1 items")};
constexpr CommandText kReorderText = {QT_TRANSLATE_NOOP("EditCommand", "Reorder %1"),
                                      QT_TRANSLATE_NOOP("EditCommand", "Reorder %1 items")};
constexpr CommandText kSwitchOnText = {QT_TRANSLATE_NOOP("EditCommand", "Switch on %1"),
                                       QT_TRANSLATE_NOOP("EditCommand", "Switch on %1 items")};
constexpr CommandText kSwitchOffText = {QT_TRANSLATE_NOOP("EditCommand", "Switch off %1"),
                                        QT_TRANSLATE_NOOP("EditCommand", "Switch off %1 items")};

QString textFor(const CommandText& text, const std::vector<Entity>& values) {
  return values.size() == 1
             ? QCoreApplication::translate("EditCommand", text.one).arg(displayName(values.front()))
             : QCoreApplication::translate("EditCommand", text.many).arg(values.size());
}

/// Applies `change` to each entity in one command.
template <class Change>
void pushEach(ScenarioDocument& document, const std::vector<EntityId>& ids,
              const CommandText& commandText, Merge merge, Change&& change) {
  std::vector<Entity> values = valuesOf(document, ids);
  const QString text = textFor(commandText, values);
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

std::string defaultStem(EntityKind kind) {
  return kind == EntityKind::Human ? "agent" : nameStem(kind);
}

/// "Ana2" -> "Ana": numbering of copies continues from there.
std::string withoutNumber(const std::string& name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  return last == std::string::npos ? name : name.substr(0, last + 1);
}

}  // namespace

std::vector<Entity> valuesOf(const ScenarioDocument& document, const std::vector<EntityId>& ids) {
  std::vector<Entity> values;
  for (const EntityId id : ids) {
    if (std::optional<Entity> value = document.entity(id)) {
      values.push_back(*std::move(value));
    }
  }
  return values;
}

std::vector<Entity> withRoute(const ScenarioDocument& document, const std::vector<EntityId>& ids,
                              const std::vector<int>& goals) {
  std::vector<Entity> values;
  for (Entity& value : valuesOf(document, ids)) {
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
  return values;
}

EntitySlot& Draft::slotOf(EntityId id) {
  const auto [place, isNew] = places_.emplace(id, edits_.size());
  if (isNew) {
    edits_.push_back({id, {}});
  }
  return edits_[place->second].slot;
}

void Draft::push(const QString& text, Merge merge) {
  const auto isIdle = [this](const EntityEdit& edit) {
    return edit.slot.value == document_.entity(edit.entity) &&
           (edit.slot.index < 0 || edit.slot.index == document_.indexOf(edit.entity));
  };
  edits_.erase(std::remove_if(edits_.begin(), edits_.end(), isIdle), edits_.end());
  for (const EntityEdit& edit : edits_) {
    const auto* human = edit.slot.value ? std::get_if<sim2d::Human>(&*edit.slot.value) : nullptr;
    if (std::optional<std::string> xml = human ? updatedTree(document_, *human) : std::nullopt) {
      setTree(edit.entity, std::move(xml));
    }
  }
  if (!edits_.empty() || !trees_.empty()) {
    document_.undoStack().push(
        new EditEntities(document_, std::move(edits_), std::move(trees_), text, merge));
  }
}

void pushEdit(ScenarioDocument& document, std::vector<Entity> values, const QString& text,
              Merge merge) {
  Draft draft(document);
  for (Entity& value : values) {
    if (document.contains(idOf(value))) {
      draft.set(std::move(value));
    }
  }
  draft.push(text, merge);
}

std::vector<EntityId> pushAdd(ScenarioDocument& document, std::vector<Entity> values,
                              const QString& text,
                              const std::map<std::size_t, std::string>& trees) {
  UniqueNames names(document.scenario());
  std::vector<EntityId> ids;
  for (Entity& value : values) {
    ids.push_back(document.newId(kindOf(value)));
    setId(value, ids.back());
    names.assignTo(value);
  }
  const QString fullText = text.isEmpty() ? textFor(kAddText, values) : text;
  Draft draft(document);
  for (Entity& value : values) {
    draft.set(std::move(value));
  }
  for (const auto& [place, xml] : trees) {
    draft.setTree(ids[place], xml);
  }
  draft.push(fullText);
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
  draft.push(textFor(kRemoveText, values));
}

void pushMove(ScenarioDocument& document, const std::vector<EntityId>& ids, const Vec2& delta,
              Merge merge) {
  pushEach(document, ids, kMoveText, merge,
           [&delta](Entity value) { return moved(std::move(value), delta); });
}

std::vector<EntityId> pushDuplicate(ScenarioDocument& document, const std::vector<EntityId>& ids,
                                    const Vec2& delta) {
  std::vector<Entity> values = valuesOf(document, ids);
  values.erase(
      std::remove_if(values.begin(), values.end(),
                     [](const Entity& value) { return kindOf(value) == EntityKind::Scenario; }),
      values.end());
  const QString text = textFor(kDuplicateText, values);
  std::map<std::size_t, std::string> trees;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::optional<std::string> xml = document.tree(idOf(values[i]))) {
      trees[i] = *std::move(xml);
    }
    values[i] = moved(std::move(values[i]), delta, true);
  }
  return pushAdd(document, std::move(values), text, trees);
}

bool pushRename(ScenarioDocument& document, EntityId id, const std::string& name) {
  std::optional<Entity> value = document.entity(id);
  if (!value || name.empty() || UniqueNames(document.scenario()).isTaken(name)) {
    return false;
  }
  const std::string old = nameOf(*value);
  Draft draft(document);
  if (kindOf(*value) == EntityKind::Human) {
    renamePerson(draft, old, name);
  }
  setName(*value, name);
  draft.set(*std::move(value));
  draft.push(
      QCoreApplication::translate("EditCommand", "Rename %1").arg(QString::fromStdString(old)));
  return true;
}

bool pushGoalNumber(ScenarioDocument& document, EntityId id, int number) {
  const sim2d::GlobalGoal* goal = document.goal(id);
  if (goal == nullptr || number < 1 || document.scenario().goal(number) != nullptr) {
    return false;
  }
  const int old = goal->id;
  Draft draft(document);
  draft.forEachGoalOfRoutes([old, number](int& each) { each = each == old ? number : each; });
  sim2d::GlobalGoal changed = *goal;
  changed.id = number;
  draft.set(changed);
  draft.push(QCoreApplication::translate("EditCommand", "Renumber goal %1").arg(old));
  return true;
}

void pushRoute(ScenarioDocument& document, const std::vector<EntityId>& humans,
               const std::vector<int>& goals) {
  std::vector<Entity> values = withRoute(document, humans, goals);
  const QString text = textFor(kRouteText, values);
  pushEdit(document, std::move(values), text);
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
  for (std::size_t i = 0; i < order.size(); ++i) {  // In order, so that each index is right.
    draft.set(*document.entity(order[i]), static_cast<int>(i));
  }
  draft.push(textFor(kReorderText, valuesOf(document, moving)));
}

void pushListed(ScenarioDocument& document, const std::vector<EntityId>& ids, bool listed) {
  const CommandText& text = listed ? kSwitchOnText : kSwitchOffText;
  pushEach(document, ids, text, Merge::Never, [listed](Entity value) {
    setListed(value, listed);
    return value;
  });
}

void pushTrees(ScenarioDocument& document, std::vector<TreeEdit> edits, const QString& text) {
  Draft draft(document);
  for (TreeEdit& edit : edits) {
    draft.setTree(edit.human, std::move(edit.xml));
  }
  draft.push(text);
}

std::string sanitizedName(const Entity& entity) {
  std::string stem;
  for (const char letter : nameOf(entity)) {
    const bool fine = base::isLetter(letter) || base::isDigit(letter) || letter == '_';
    stem += fine ? letter : '_';
  }
  const bool startsWell = !stem.empty() && base::isLetter(stem[0]);
  return startsWell ? stem : nameStem(kindOf(entity)) + stem;
}

UniqueNames::UniqueNames(const sim2d::Scenario& scenario) {
  forEachList(scenario, [this](EntityKind /*kind*/, const auto& list) {
    for (const auto& value : list) {
      if constexpr (kIsNamed<std::decay_t<decltype(value)>>) {
        names_.insert(value.name);
      } else {
        goals_.insert(value.id);
      }
    }
  });
  for (const sim2d::Human& human : scenario.humans) {
    humans_.insert(human.id);
  }
}

std::string UniqueNames::name(const std::string& stem) {
  for (int& number = next_.emplace(stem, 1).first->second;; ++number) {
    std::string candidate = stem + std::to_string(number);
    if (names_.insert(candidate).second) {
      return candidate;
    }
  }
}

void UniqueNames::assignTo(Entity& value) {
  if (auto* goal = std::get_if<sim2d::GlobalGoal>(&value)) {
    if (goal->id < 1 || goals_.count(goal->id) > 0) {
      goal->id = nextGoal();
    }
    goals_.insert(goal->id);
    return;
  }
  if (auto* human = std::get_if<sim2d::Human>(&value)) {
    if (human->id < 0 || humans_.count(human->id) > 0) {
      human->id = nextHuman();
    }
    humans_.insert(human->id);
  }
  const std::string wanted = nameOf(value);
  if (wanted.empty() || isTaken(wanted)) {
    setName(value, name(wanted.empty() ? defaultStem(kindOf(value)) : withoutNumber(wanted)));
  } else {
    names_.insert(wanted);
  }
}

}  // namespace editor
