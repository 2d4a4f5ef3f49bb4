#include "editor/tools/WallTool.h"

#include "editor/canvas/MapScene.h"
#include "editor/tools/SpanTool.h"

namespace editor {

namespace {

sim2d::Obstacle wallAlong(const std::vector<Vec2>& corners) {
  sim2d::Obstacle wall;
  wall.key = ghostOf(EntityKind::Obstacle);
  wall.kind = sim2d::ObstacleKind::Wall;
  wall.points = corners;
  return wall;
}

}  // namespace

QString WallTool::problemOf(const Corners& corners) const {
  if (corners.size() < 2) {
    return tr("Two corners or more are needed");
  }
  double length = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    length += (corners[i] - corners[i - 1]).norm();
  }
  return length < kLeastLength ? tr("Too short") : QString();
}

void WallTool::preview(const Corners& corners) {
  scene().setPreview({wallAlong(corners)});
}

void WallTool::make(const Corners& corners) {
  addDrawn(document(), wallAlong(corners), "wall", tr("Add wall"));
}

}  // namespace editor
