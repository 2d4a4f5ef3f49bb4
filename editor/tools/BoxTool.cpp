#include "editor/tools/BoxTool.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/MapScene.h"
#include "editor/canvas/Snap.h"
#include "editor/tools/CornerTool.h"

namespace editor {

std::optional<Entity> BoxTool::spanned(const Vec2& from, const Vec2& to) const {
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

Vec2 BoxTool::endFor(const Vec2& from, const CanvasMouse& mouse) const {
  const Vec2 to = snap(mouse, {});
  if (!mouse.modifiers.testFlag(Qt::ShiftModifier)) {
    return to;
  }
  const double side = (to - from).cwiseAbs().maxCoeff();
  return from +
         Vec2(std::copysign(side, to.x() - from.x()), std::copysign(side, to.y() - from.y()));
}

QString BoxTool::tagFor(const Vec2& from, const Vec2& to) const {
  const Vec2 size = (to - from).cwiseAbs();
  return QStringLiteral("%1 × %2 m").arg(size.x(), 0, 'f', 2).arg(size.y(), 0, 'f', 2);
}

}  // namespace editor
