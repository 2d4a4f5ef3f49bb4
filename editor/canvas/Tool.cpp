#include "editor/canvas/Tool.h"

#include "editor/canvas/Layers.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/Snap.h"

namespace editor {

Tool::Tool(ScenarioDocument& document, MapScene& scene, QObject* parent)
    : QObject(parent), document_(document), scene_(scene) {}

Vec2 Tool::snap(const CanvasMouse& mouse, const SnapWish& wish) const {
  const Snapped result = snapped(scene_, mouse, wish);
  scene_.toolLayer().setSnapMark(result.isOnPoint ? std::optional<Vec2>(result.point)
                                                  : std::nullopt);
  return result.point;
}

Vec2 Tool::snapToGrid(const CanvasMouse& mouse) const {
  SnapWish wish;
  wish.ontoPoints = false;
  return snapped(scene_, mouse, wish).point;
}

void Tool::clearMarks() {
  scene_.clearPreview();
  scene_.toolLayer().clear();
  Q_EMIT statusTextChanged();
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

QString legText(const Vec2& from, const Vec2& to) {
  return QStringLiteral("%1 m · %2")
      .arg((to - from).norm(), 0, 'f', 2)
      .arg(headingText(base::headingOf(to - from)));
}

}  // namespace editor
