#include "editor/canvas/MapScene.h"
#include "editor/tools/Drawing.h"
#include "editor/tools/ToolRegistry.h"
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

/// Obstacles of any outline; a drag makes a rectangle along the axes.
class PolygonTool : public CornerDrawing {
 public:
  using CornerDrawing::CornerDrawing;

 protected:
  QString idleText() const override {
    return tr("Click the corners of an obstacle; the first one again closes it");
  }
  void preview(const Corners& corners) override { scene().setPreview({polygonOf(corners)}); }

  void make(const Corners& corners) override {
    addDrawn(document(), polygonOf(corners), "polygon", tr("Add polygon"));
  }
};

}  // namespace

void addPolygonTool(ToolRegistry& to) {
  to.add<PolygonTool>({90, QObject::tr("Polygon"), QStringLiteral("tool-polygon"), Qt::Key_Y,
                       QStringLiteral("shape")});
}

}  // namespace editor
