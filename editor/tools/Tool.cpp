#include "editor/tools/Tool.h"

#include <cmath>

#include "editor/canvas/MapScene.h"

namespace editor {

Tool::Tool(ScenarioDocument& document, MapScene& scene, QObject* parent)
    : QObject(parent), document_(document), scene_(scene) {}

Vec2 placed(const Vec2& world, Qt::KeyboardModifiers modifiers) {
  if (modifiers.testFlag(Qt::AltModifier)) {
    return world;
  }
  const double step = modifiers.testFlag(Qt::ControlModifier) ? 0.5 : 0.01;
  return {std::round(world.x() / step) * step, std::round(world.y() / step) * step};
}

bool isDrag(const Vec2& from, const CanvasMouse& mouse) {
  return (mouse.world - from).norm() * mouse.pixelsPerMetre >= kDragPx;
}

QString placeText(const Vec2& world) {
  return QStringLiteral("%1, %2 m").arg(world.x(), 0, 'f', 2).arg(world.y(), 0, 'f', 2);
}

QString headingText(double heading) {
  return QStringLiteral("%1°").arg(heading * 180.0 / base::kPi, 0, 'f', 1);
}

}  // namespace editor
