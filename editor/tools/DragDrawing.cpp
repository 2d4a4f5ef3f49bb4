#include "editor/tools/DragDrawing.h"

#include "editor/canvas/Layers.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/Snap.h"
#include "editor/document/EditCommands.h"
#include "editor/document/FreeNames.h"

namespace editor {

EntityId ghostOf(EntityKind kind) {
  return {kind, -1};
}

void addDrawn(ScenarioDocument& document, Entity value, const std::string& stem,
              const QString& undoText) {
  setName(value, freeName(document.scenario(), stem));
  document.setSelection(pushAdd(document, std::vector<Entity>{std::move(value)}, undoText));
}

Vec2 DragDrawing::endFor(const Vec2& from, const CanvasMouse& mouse) const {
  SnapWish wish;
  wish.anchor = from;
  return snap(mouse, wish);
}

void DragDrawing::press(const CanvasMouse& mouse) {
  if (mouse.button != Qt::LeftButton) {
    cancel();
    return;
  }
  from_ = snap(mouse, {});
  pressedAt_ = mouse.world;
  Q_EMIT statusTextChanged();
}

void DragDrawing::move(const CanvasMouse& mouse) {
  if (!from_) {
    snap(mouse, {});
    return;
  }
  if (!isDrag(pressedAt_, mouse)) {
    return;
  }
  const Vec2 to = endFor(*from_, mouse);
  if (const std::optional<Entity> entity = spanned(*from_, to)) {
    scene().setPreview({*entity});
  } else {
    scene().clearPreview();
  }
  scene().toolLayer().setTag(mouse.world, tagFor(*from_, to));
}

void DragDrawing::release(const CanvasMouse& mouse) {
  if (mouse.button != Qt::LeftButton || !from_) {
    return;
  }
  const Vec2 from = *from_;
  const std::optional<Entity> entity =
      isDrag(pressedAt_, mouse) ? spanned(from, endFor(from, mouse)) : std::nullopt;
  cancel();
  if (entity) {
    addDrawn(document(), *entity, nameOf(*entity), undoText());
  }
}

void DragDrawing::cancel() {
  from_.reset();
  scene().clearPreview();
  scene().toolLayer().clear();
  Q_EMIT statusTextChanged();
}

}  // namespace editor
