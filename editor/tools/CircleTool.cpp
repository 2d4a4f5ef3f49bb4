#include <cmath>

#include "editor/tools/Drawing.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

/// Round obstacles: pressed at the centre, dragged to the rim.
class CircleTool : public DragDrawing {
 public:
  using DragDrawing::DragDrawing;

  QString statusText() const override {
    return tr("Press at the centre of the circle, drag to its rim");
  }

 protected:
  std::optional<Entity> spanned(const Vec2& from, const Vec2& to) const override {
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

  QString tagFor(const Vec2& from, const Vec2& to) const override {
    return tr("radius %1 m").arg((to - from).norm(), 0, 'f', 2);
  }

  QString undoText() const override { return tr("Add circle"); }
};

}  // namespace

void addCircleTool(ToolRegistry& to) {
  to.add<CircleTool>({100, QObject::tr("Circle"), QStringLiteral("tool-circle"), Qt::Key_C,
                      QStringLiteral("shape")});
}

}  // namespace editor
