#include "editor/tools/PolygonTool.h"

#include "editor/canvas/MapScene.h"
#include "editor/tools/SpanTool.h"
#include "sim2d/map/Outlines.h"

namespace editor {

namespace {

sim2d::Obstacle polygonOf(const std::vector<Vec2>& corners) {
  sim2d::Obstacle polygon;
  polygon.key = ghostOf(EntityKind::Obstacle);
  polygon.kind = sim2d::ObstacleKind::Polygon;
  polygon.points = sim2d::polygonOutline(corners).points;
  return polygon;
}

}  // namespace

void PolygonTool::preview(const Corners& corners) {
  scene().setPreview({polygonOf(corners)});
}

void PolygonTool::make(const Corners& corners) {
  addDrawn(document(), polygonOf(corners), "polygon", tr("Add polygon"));
}

}  // namespace editor
