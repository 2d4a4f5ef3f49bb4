#pragma once

#include "editor/tools/CornerTool.h"

namespace editor {

/// Obstacles of any outline; a drag makes a rectangle along the axes.
class PolygonTool : public CornerTool {
  Q_OBJECT
 public:
  using CornerTool::CornerTool;

  QString name() const override { return tr("Polygon"); }
  QString iconName() const override { return QStringLiteral("tool-polygon"); }
  QKeySequence shortcut() const override { return QKeySequence(Qt::Key_Y); }

 protected:
  QString idleText() const override {
    return tr("Click the corners of an obstacle; the first one again closes it");
  }
  void preview(const Corners& corners) override;
  void make(const Corners& corners) override;
};

}  // namespace editor
