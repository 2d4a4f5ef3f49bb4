#include "editor/canvas/MapScene.h"
#include "editor/tools/Drawing.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

sim2d::Obstacle wallAlong(const std::vector<Vec2>& corners) {
  sim2d::Obstacle wall;
  wall.key = ghostOf(EntityKind::Obstacle);
  wall.kind = sim2d::ObstacleKind::Wall;
  wall.points = corners;
  return wall;
}

/// Walls as polylines, 0.1 m thick; a drag makes one straight wall.
class WallTool : public CornerDrawing {
 public:
  using CornerDrawing::CornerDrawing;

 protected:
  QString idleText() const override {
    return tr("Drag a wall, or click its corners one by one · Shift: 15° steps");
  }
  bool isClosed() const override { return false; }
  QString problemOf(const Corners& corners) const override {
    if (corners.size() < 2) {
      return tr("Two corners or more are needed");
    }
    double length = 0.0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      length += (corners[i] - corners[i - 1]).norm();
    }
    return length < kLeastLength ? tr("Too short") : QString();
  }

  void preview(const Corners& corners) override { scene().setPreview({wallAlong(corners)}); }

  void make(const Corners& corners) override {
    addDrawn(document(), wallAlong(corners), "wall", tr("Add wall"));
  }

  Corners dragged(const Vec2& from, const Vec2& to) const override { return {from, to}; }
};

}  // namespace

void addWallTool(ToolRegistry& to) {
  to.add<WallTool>(
      {70, QObject::tr("Wall"), QStringLiteral("tool-wall"), Qt::Key_W, QStringLiteral("shape")});
}

}  // namespace editor
