#pragma once

#include "editor/document/ScenarioDocument.h"

namespace editor {

enum class Merge { Never, WithPrevious };  // Nudges and spin boxes merge.

/// A person and their new custom tree (XML text); none = the generated tree.
struct TreeEdit {
  EntityId human;
  std::optional<std::string> xml;
};

/// The existing entities among `ids`.
std::vector<Entity> valuesOf(const ScenarioDocument& document, const std::vector<EntityId>& ids);
/// The people and robots among `ids`, with the given route.
std::vector<Entity> withRoute(const ScenarioDocument& document, const std::vector<EntityId>& ids,
                              const std::vector<int>& goals);

/// Each function pushes at most one command, and none if nothing would change.
void pushEdit(ScenarioDocument& document, std::vector<Entity> values, const QString& text,
              Merge merge = Merge::Never);
/// Assigns new keys to the entities, and unique names and numbers where theirs are empty or taken.
/// `trees`: custom trees of people by index in `values`. Returns the ids.
std::vector<EntityId> pushAdd(ScenarioDocument& document, std::vector<Entity> values,
                              const QString& text,
                              const std::map<std::size_t, std::string>& trees = {});
EntityId pushAdd(ScenarioDocument& document, Entity value);
/// Also updates routes and sources that refer to a removed entity, in the same command.
void pushRemove(ScenarioDocument& document, const std::vector<EntityId>& ids);
void pushMove(ScenarioDocument& document, const std::vector<EntityId>& ids, const Vec2& delta,
              Merge merge = Merge::Never);
/// Copies the entities; the caller selects the copies. A copied person shares the goals of the
/// original.
std::vector<EntityId> pushDuplicate(ScenarioDocument& document, const std::vector<EntityId>& ids,
                                    const Vec2& delta);
/// Renames an entity and updates all references to it. Returns false if the name is empty or taken.
bool pushRename(ScenarioDocument& document, EntityId id, const std::string& name);
/// Changes the number of a goal and updates routes. Returns false if the number is taken or below
/// 1.
bool pushGoalNumber(ScenarioDocument& document, EntityId goal, int number);
void pushRoute(ScenarioDocument& document, const std::vector<EntityId>& humans,
               const std::vector<int>& goals);
/// Moves several entities of one kind together, in their order, to before the entity at `index`.
/// Entities that are switched off stay behind the others.
void pushReorder(ScenarioDocument& document, const std::vector<EntityId>& ids, int index);
/// Switches entities on or off.
void pushListed(ScenarioDocument& document, const std::vector<EntityId>& ids, bool listed);
/// Sets trees, also if nothing changes. Each person must occur only once.
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

/// An entity and its new value; no value = removed.
struct EntityEdit {
  EntityId entity;
  EntitySlot slot;
};

/// The changes of a command under construction: values by entity, which equal those of the document
/// unless edited before, and custom trees of people.
class Draft {
 public:
  explicit Draft(ScenarioDocument& document) : document_(document) {}

  void set(Entity value, int index = -1) {
    const EntityId id = idOf(value);
    slotOf(id) = {std::move(value), index};
  }
  void remove(EntityId id) { slotOf(id) = {}; }
  void setTree(EntityId human, std::optional<std::string> xml) {
    trees_.push_back({human, std::move(xml)});
  }

  /// Calls `change` for each entity of type T in the document that is not removed by the draft.
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
  /// Calls `change` for each goal number in the routes of people and robots.
  template <class Change>
  void forEachGoalOfRoutes(Change&& change) {
    forEach<sim2d::Human>([&](sim2d::Human& human) {
      std::for_each(human.goals.begin(), human.goals.end(), change);
    });
    forEach<sim2d::Robot>([&](sim2d::Robot& robot) {
      std::for_each(robot.goal.goals.begin(), robot.goal.goals.end(), change);
    });
  }

  /// Pushes at most one command. It may merge with a previous command that has the same text and
  /// the same entities. Generated trees with blocks are updated with the behaviour and the goals of
  /// their people.
  void push(const QString& text, Merge merge = Merge::Never);

 private:
  EntitySlot& slotOf(EntityId id);

  ScenarioDocument& document_;
  std::vector<EntityEdit> edits_;
  std::map<EntityId, std::size_t> places_;  // Index in edits_.
  std::vector<TreeEdit> trees_;
};

/// Generates names and numbers that are not used in a scenario and that the same object has not
/// generated before.
class UniqueNames {
 public:
  explicit UniqueNames(const sim2d::Scenario& scenario);
  /// Assigns a name, and a number to goals and people, where it is missing or taken.
  void assignTo(Entity& value);
  std::string name(const std::string& stem);  // "agent1", "agent2" …
  bool isTaken(const std::string& name) const { return names_.count(name) > 0; }
  int nextGoal() const { return goals_.empty() ? 1 : *goals_.rbegin() + 1; }
  int nextHuman() const { return humans_.empty() ? 1 : *humans_.rbegin() + 1; }

 private:
  std::set<std::string> names_;
  std::map<std::string, int> next_;  // The next number to try for a stem; lower ones are taken.
  std::set<int> goals_, humans_;
};

/// The name reduced to the characters that files allow.
std::string sanitizedName(const Entity& entity);

}  // namespace editor
