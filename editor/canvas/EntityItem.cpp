#include "editor/canvas/EntityItem.h"

namespace editor {

QRectF around(const QPointF& centre, double reach) {
  return {centre.x() - reach, centre.y() - reach, 2.0 * reach, 2.0 * reach};
}

void EntityItem::sync(const Entity& value) {
  take(value);
  zoomChanged();
  update();
}

void EntityItem::zoomChanged() {
  const QRectF fresh = bounds(scene_.pixelsPerMetre());
  if (fresh != bounds_) {
    prepareGeometryChange();
    bounds_ = fresh;
  }
}

void paintRobotGoal(QPainter& painter, const Theme& theme) {
  painter.setPen(QPen(theme.color(Role::RobotBody), 2.0));
  painter.setBrush(theme.color(Role::MapFree));
  painter.drawEllipse(QPointF(), kRobotGoalPx, kRobotGoalPx);
  painter.setPen(QPen(theme.color(Role::RobotBody), 1.2));
  painter.setBrush(theme.color(Role::RobotFront));
  painter.drawEllipse(QPointF(), 0.52 * kRobotGoalPx, 0.52 * kRobotGoalPx);
}

std::unique_ptr<EntityItem> makeEntityItem(const MapScene& scene, EntityId id) {
  switch (id.kind) {
    case EntityKind::Human:
      return makePersonItem(scene, id);
    case EntityKind::Robot:
      return makeRobotItem(scene, id);
    case EntityKind::Goal:
      return makeGoalItem(scene, id);
    case EntityKind::Obstacle:
    case EntityKind::Door:
    case EntityKind::Area:
      return makeShapeItem(scene, id);
    case EntityKind::Scenario:
    case EntityKind::None:
      break;
  }
  return nullptr;
}

}  // namespace editor
