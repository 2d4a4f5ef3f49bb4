#include <algorithm>
#include <cmath>

#include "editor/canvas/MapScene.h"
#include "editor/canvas/Tool.h"
#include "editor/tools/Drawing.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

/// Boxes from corner to corner; with Shift squares.
class BoxTool : public DragDrawing {
 public:
  using DragDrawing::DragDrawing;

  QString statusText() const override {
    return tr("Drag a box from corner to corner · Shift makes a square");
  }

 protected:
  std::optional<Entity> spanned(const Vec2& from, const Vec2& to) const override {
    const Vec2 size = (to - from).cwiseAbs();
    if (size.minCoeff() < kLeastLength) {
      return std::nullopt;
    }
    sim2d::Obstacle box;
    box.key = ghostOf(EntityKind::Obstacle);
    box.name = "box";
    box.kind = sim2d::ObstacleKind::Box;
    box.pose.position = 0.5 * (from + to);
    box.length = size.x();
    box.width = size.y();
    return box;
  }

  Vec2 endFor(const Vec2& from, const CanvasMouse& mouse) const override {
    const Vec2 to = snap(mouse, {});
    if (!mouse.modifiers.testFlag(Qt::ShiftModifier)) {
      return to;
    }
    const double side = (to - from).cwiseAbs().maxCoeff();
    return from +
           Vec2(std::copysign(side, to.x() - from.x()), std::copysign(side, to.y() - from.y()));
  }

  QString tagFor(const Vec2& from, const Vec2& to) const override {
    const Vec2 size = (to - from).cwiseAbs();
    return QStringLiteral("%1 × %2 m").arg(size.x(), 0, 'f', 2).arg(size.y(), 0, 'f', 2);
  }

  QString undoText() const override { return tr("Add box"); }
};

}  // namespace

void addBoxTool(ToolRegistry& to) {
  to.add<BoxTool>(
      {80, QObject::tr("Box"), QStringLiteral("tool-box"), Qt::Key_O, QStringLiteral("shape")});
}

}  // namespace editor
