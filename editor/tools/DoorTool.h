#pragma once

#include "editor/tools/SpanTool.h"

namespace editor {

/// Doors: from the hinge to the other jamb, open at the start.
class DoorTool : public SpanTool {
  Q_OBJECT
 public:
  using SpanTool::SpanTool;

  QString name() const override { return tr("Door"); }
  QString iconName() const override { return QStringLiteral("tool-door"); }
  QKeySequence shortcut() const override { return QKeySequence(Qt::Key_D); }
  QString statusText() const override {
    return tr("Drag a door from its hinge to the other jamb · Shift: 15° steps");
  }

 protected:
  std::optional<Entity> spanned(const Vec2& from, const Vec2& to) const override;

  QString undoText() const override { return tr("Add door"); }
};

}  // namespace editor
