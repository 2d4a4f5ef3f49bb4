#pragma once

#include "editor/tools/CornerTool.h"

namespace editor {

/// Walls as polylines, 0.1 m thick; a drag makes one straight wall.
class WallTool : public CornerTool {
  Q_OBJECT
 public:
  using CornerTool::CornerTool;

  QString name() const override { return tr("Wall"); }
  QString iconName() const override { return QStringLiteral("tool-wall"); }
  QKeySequence shortcut() const override { return QKeySequence(Qt::Key_W); }

 protected:
  QString idleText() const override {
    return tr("Drag a wall, or click its corners one by one · Shift: 15° steps");
  }
  bool isClosed() const override { return false; }
  QString problemOf(const Corners& corners) const override;
  void preview(const Corners& corners) override;
  void make(const Corners& corners) override;
  Corners dragged(const Vec2& from, const Vec2& to) const override { return {from, to}; }
};

}  // namespace editor
