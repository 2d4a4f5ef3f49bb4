#include "editor/tools/SelectToolTexts.h"

#include <algorithm>

#include "editor/canvas/MapScene.h"
#include "editor/document/ScenarioDocument.h"

namespace editor {

namespace {

bool hasHandle(const Entity& entity, Handle::Kind kind) {
  const std::vector<Handle> handles = handlesOf(entity, {});
  return std::any_of(handles.begin(), handles.end(),
                     [kind](const Handle& handle) { return handle.kind == kind; });
}

}  // namespace

QString SelectToolTexts::ofRun(const MapScene& scene) {
  if (scene.pull()) {
    return tr("The robot follows until you release the button");
  }
  if (scene.placement()) {
    return tr("Release to branch with the person here");
  }
  if (scene.armedPush()) {
    return tr("Drag an arrow: a longer arrow pushes harder · Esc cancels");
  }
  if (scene.isPlaceable()) {
    return tr(
        "Click a person for details · Drag a person to branch with another position · "
        "Space resumes");
  }
  return scene.isPullable() ? tr("Click a person for details · Shift+drag to push · Drag a "
                                 "robot to lead it · Space pauses")
                            : tr("Click a person for details · Space pauses");
}

QString SelectToolTexts::ofSelection(const ScenarioDocument& document) {
  const std::optional<Entity> value = document.entity(document.selection().front());
  const bool isOnly = document.selection().size() == 1 && value;
  QStringList parts{tr("Drag to move")};
  if (isOnly && hasHandle(*value, Handle::Kind::Turn)) {
    parts << tr("Drag the round handle to turn");
  } else if (isOnly && hasHandle(*value, Handle::Kind::Size)) {
    parts << tr("Drag a corner to resize");
  }
  if (isOnly && cornersOf(*value) != nullptr) {
    parts << tr("Double-click an edge to add a corner");
  } else {
    parts << tr("Ctrl+D duplicates") << tr("Del removes");
  }
  return parts.join(QString::fromUtf8(" · "));
}

}  // namespace editor
