#pragma once

#include "editor/tools/SpanTool.h"

namespace editor {

/// Boxes from corner to corner; with Shift squares.
class BoxTool : public SpanTool {
  Q_OBJECT
 public:
  using SpanTool::SpanTool;

  QString name() const override { return tr("Box"); }
  QString iconName() const override { return QStringLiteral("tool-box"); }
  QKeySequence shortcut() const override { return QKeySequence(Qt::Key_O); }
  QString statusText() const override {
    return tr("Drag a box from corner to corner · Shift makes a square");
  }

 protected:
  std::optional<Entity> spanned(const Vec2& from, const Vec2& to) const override;
  Vec2 endFor(const Vec2& from, const CanvasMouse& mouse) const override;
  QString tagFor(const Vec2& from, const Vec2& to) const override;
  QString undoText() const override { return tr("Add box"); }
};

}  // namespace editor
