#pragma once

#include <utility>
#include <vector>

#include <QUndoCommand>

#include "editor/document/ScenarioDocument.h"

namespace editor {

enum class Merge { Never, WithPrevious };  // nudges and spin boxes merge

/// One entity and what it becomes; no value = removed.
struct EntityEdit {
  EntityId entity;
  EntitySlot slot;
};

/// The one command: redo and undo swap values with the document. Several entities in one command
/// are swapped in order, and back in the opposite order. Merges with a command of the same text on
/// the same entities; dropped when everything is back where it began.
class EditEntity : public QUndoCommand {
 public:
  EditEntity(ScenarioDocument& document, std::vector<EntityEdit> edits, const QString& text,
             Merge merge = Merge::Never);
  void redo() override;
  void undo() override;
  int id() const override;
  bool mergeWith(const QUndoCommand* other) override;

 private:
  ScenarioDocument& document_;
  std::vector<EntityEdit> edits_;
  Merge merge_;
};

/// A person and the own tree to be (XML text); none = the generated one.
struct TreeEdit {
  EntityId human;
  std::optional<std::string> xml;
};

/// Swaps the trees of people, each of whom is named once.
class EditTree : public QUndoCommand {
 public:
  EditTree(ScenarioDocument& document, std::vector<TreeEdit> edits, const QString& text);
  EditTree(ScenarioDocument& document, EntityId human, std::optional<std::string> xml,
           const QString& text);
  void redo() override { swap(); }
  void undo() override { swap(); }

 private:
  void swap();
  ScenarioDocument& document_;
  std::vector<TreeEdit> edits_;
};

/// Each function pushes at most one command; nothing is pushed when nothing would change.
void pushEdit(ScenarioDocument& document, std::vector<Entity> values, const QString& text,
              Merge merge = Merge::Never);
/// Gives the entities fresh keys, and names and numbers that are free where theirs are empty or
/// taken. Returns their ids.
std::vector<EntityId> pushAdd(ScenarioDocument& document, std::vector<Entity> values,
                              const QString& text);
EntityId pushAdd(ScenarioDocument& document, Entity value);
/// Routes and sources that name what is removed are put right in the same command.
void pushRemove(ScenarioDocument& document, const std::vector<EntityId>& ids);
void pushMove(ScenarioDocument& document, const std::vector<EntityId>& ids, const Vec2& delta,
              Merge merge = Merge::Never);
void pushTurn(ScenarioDocument& document, const std::vector<EntityId>& ids, double heading);
/// Copies beside the originals, selected by the caller. Goals of a copied person stay shared.
std::vector<EntityId> pushDuplicate(ScenarioDocument& document, const std::vector<EntityId>& ids,
                                    const Vec2& delta);
/// A new name; what names it follows. False when the name is empty or taken.
bool pushRename(ScenarioDocument& document, EntityId id, const std::string& name);
/// Another number for a goal; routes follow. False when it is taken or below 1.
bool pushGoalNumber(ScenarioDocument& document, EntityId goal, int number);
void pushRoute(ScenarioDocument& document, const std::vector<EntityId>& humans,
               const std::vector<int>& goals);
/// Move an entity to another place in its list.
void pushReorder(ScenarioDocument& document, EntityId id, int index);
/// Several of one kind, together and in their order, to before what stands at `index` now; those
/// that are switched off stay behind the others.
void pushReorder(ScenarioDocument& document, const std::vector<EntityId>& ids, int index);
bool isListed(const Entity& entity);  // takes part; goals and settings always do
/// Switches them on or off.
void pushListed(ScenarioDocument& document, const std::vector<EntityId>& ids, bool listed);

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

/// Names and numbers that are free.
std::string freeName(const sim2d::Scenario& scenario, const std::string& stem);
int freeGoalId(const sim2d::Scenario& scenario);
int freeHumanId(const sim2d::Scenario& scenario);
bool isNameTaken(const sim2d::Scenario& scenario, const std::string& name);

}  // namespace editor
