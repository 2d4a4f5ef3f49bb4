#include "editor/tools/SelectionActions.h"

#include "editor/document/EditCommands.h"

namespace editor {

void removeSelection(ScenarioDocument& document) {
  const std::vector<EntityId> ids = document.selection();
  pushRemove(document, ids);
}

void duplicateSelection(ScenarioDocument& document) {
  document.setSelection(pushDuplicate(document, document.selection(), Vec2(0.8, -0.8)));
}

void selectAll(ScenarioDocument& document) {
  std::vector<EntityId> all;
  for (const EntityKind kind : {EntityKind::Human, EntityKind::Goal, EntityKind::Robot,
                                EntityKind::Obstacle, EntityKind::Door, EntityKind::Area}) {
    const std::vector<EntityId> ids = document.entities(kind);
    all.insert(all.end(), ids.begin(), ids.end());
  }
  document.setSelection(std::move(all));
}

}  // namespace editor
