#pragma once

#include "editor/tools/SpanTool.h"

namespace editor {

/// Round obstacles: pressed at the centre, dragged to the rim.
class CircleTool : public SpanTool {
  Q_OBJECT
 public:
  using SpanTool::SpanTool;

  QString name() const override { return tr("Circle"); }
  QString iconName() const override { return QStringLiteral("tool-circle"); }
  QKeySequence shortcut() const override { return QKeySequence(Qt::Key_C); }
  QString statusText() const override {
    return tr("Press at the centre of the circle, drag to its rim");
  }

 protected:
  std::optional<Entity> spanned(const Vec2& from, const Vec2& to) const override;
  QString tagFor(const Vec2& from, const Vec2& to) const override;
  QString undoText() const override { return tr("Add circle"); }
};

}  // namespace editor
