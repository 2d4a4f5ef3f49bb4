#include "editor/tools/CircleTool.h"

#include <cmath>

#include "editor/tools/CornerTool.h"

namespace editor {

std::optional<Entity> CircleTool::spanned(const Vec2& from, const Vec2& to) const {
  const double radius = std::round((to - from).norm() * 100.0) / 100.0;
  if (radius < kLeastLength) {
    return std::nullopt;
  }
  sim2d::Obstacle circle;
  circle.key = ghostOf(EntityKind::Obstacle);
  circle.name = "circle";
  circle.kind = sim2d::ObstacleKind::Circle;
  circle.pose.position = from;
  circle.radius = radius;
  return circle;
}

QString CircleTool::tagFor(const Vec2& from, const Vec2& to) const {
  return tr("radius %1 m").arg((to - from).norm(), 0, 'f', 2);
}

}  // namespace editor
