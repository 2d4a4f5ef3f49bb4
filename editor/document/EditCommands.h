#pragma once

#include <map>
#include <utility>
#include <vector>

#include "editor/document/EntityLists.h"
#include "editor/document/ScenarioDocument.h"

namespace editor {

enum class Merge { Never, WithPrevious };  // nudges and spin boxes merge

/// A person and the own tree to be (XML text); none = the generated one.
struct TreeEdit {
  EntityId human;
  std::optional<std::string> xml;
};

/// Those of them that are there.
std::vector<Entity> valuesOf(const ScenarioDocument& document, const std::vector<EntityId>& ids);
/// The people and robots among them, with that route.
std::vector<Entity> withRoute(const ScenarioDocument& document, const std::vector<EntityId>& ids,
                              const std::vector<int>& goals);

/// Each function pushes at most one command; nothing is pushed when nothing would change.
void pushEdit(ScenarioDocument& document, std::vector<Entity> values, const QString& text,
              Merge merge = Merge::Never);
/// Gives the entities fresh keys, and names and numbers that are free where theirs are empty or
/// taken. `trees`: own ones of people, by place among the entities. Returns their ids.
std::vector<EntityId> pushAdd(ScenarioDocument& document, std::vector<Entity> values,
                              const QString& text,
                              const std::map<std::size_t, std::string>& trees = {});
EntityId pushAdd(ScenarioDocument& document, Entity value);
/// Routes and sources that name what is removed are put right in the same command.
void pushRemove(ScenarioDocument& document, const std::vector<EntityId>& ids);
void pushMove(ScenarioDocument& document, const std::vector<EntityId>& ids, const Vec2& delta,
              Merge merge = Merge::Never);
/// Copies beside the originals, selected by the caller. Goals of a copied person stay shared.
std::vector<EntityId> pushDuplicate(ScenarioDocument& document, const std::vector<EntityId>& ids,
                                    const Vec2& delta);
/// A new name; what names it follows. False when the name is empty or taken.
bool pushRename(ScenarioDocument& document, EntityId id, const std::string& name);
/// Another number for a goal; routes follow. False when it is taken or below 1.
bool pushGoalNumber(ScenarioDocument& document, EntityId goal, int number);
void pushRoute(ScenarioDocument& document, const std::vector<EntityId>& humans,
               const std::vector<int>& goals);
/// Several of one kind, together and in their order, to before what stands at `index` now; those
/// that are switched off stay behind the others.
void pushReorder(ScenarioDocument& document, const std::vector<EntityId>& ids, int index);
/// Switches them on or off.
void pushListed(ScenarioDocument& document, const std::vector<EntityId>& ids, bool listed);
/// Also where nothing changes. Each person is named once.
void pushTrees(ScenarioDocument& document, std::vector<TreeEdit> edits, const QString& text);

/// pushChange<sim2d::Human>(document, id, tr("Speed"), [](sim2d::Human& h) { h.maxVel = 1.2; });
template <class T, class Change>
void pushChange(ScenarioDocument& document, EntityId id, const QString& text, Change&& change,
                Merge merge = Merge::Never) {
  std::optional<Entity> value = document.entity(id);
  if (!value || !std::holds_alternative<T>(*value)) {
    return;
  }
  std::forward<Change>(change)(std::get<T>(*value));
  pushEdit(document, {std::move(*value)}, text, merge);
}

/// One entity and what it becomes; no value = removed.
struct EntityEdit {
  EntityId entity;
  EntitySlot slot;
};

/// What a command will change while it is being put together: values by entity, which are the
/// document's unless edited before, and own trees of people.
class Draft {
 public:
  explicit Draft(ScenarioDocument& document) : document_(document) {}

  void set(Entity value, int index = -1);
  void remove(EntityId id) { slotOf(id) = {}; }
  void setTree(EntityId human, std::optional<std::string> xml);

  /// Calls `change` for every entity of type T in the document that is not removed by the draft.
  template <class T, class Change>
  void forEach(Change&& change) {
    for (const T& original : listOf<T>(document_.scenario())) {
      const auto found = places_.find(original.key);
      const EntitySlot* slot = found == places_.end() ? nullptr : &edits_[found->second].slot;
      if (slot != nullptr && !slot->value) {
        continue;
      }
      T value = slot == nullptr ? original : std::get<T>(*slot->value);
      change(value);
      if (!(value == original)) {
        set(std::move(value));
      }
    }
  }
  /// Calls `change` for the number of every goal in the routes of people and robots.
  template <class Change>
  void forEachGoalOfRoutes(Change&& change) {
    forEach<sim2d::Human>([&](sim2d::Human& human) {
      std::for_each(human.goals.begin(), human.goals.end(), change);
    });
    forEach<sim2d::Robot>([&](sim2d::Robot& robot) {
      std::for_each(robot.goal.goals.begin(), robot.goal.goals.end(), change);
    });
  }

  /// At most one command, which merges with a command of the same text on the same entities when
  /// it may. Trees with blocks keep up with the behaviour and the goals of their people.
  void push(const QString& text, Merge merge = Merge::Never);

 private:
  EntitySlot& slotOf(EntityId id);

  ScenarioDocument& document_;
  std::vector<EntityEdit> edits_;
  std::map<EntityId, std::size_t> places_;  // in edits_
  std::vector<TreeEdit> trees_;
};

}  // namespace editor
