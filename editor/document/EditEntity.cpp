#include <algorithm>

#include "editor/document/EditCommands.h"

namespace editor {

namespace {

constexpr int kEditEntity = 1;

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

}  // namespace editor
