#include <cmath>

#include "editor/tools/DrawingTools.h"
#include "editor/tools/ToolRegistry.h"
#include "sim2d/map/Outlines.h"

// Tools for obstacles and doors.
namespace editor {

namespace {

constexpr double kNarrowestDoor = 0.2;  // [m]
constexpr double kMinLength = 0.05;     // Minimum side length [m].

sim2d::Obstacle obstacleOf(sim2d::ObstacleKind kind, std::vector<Vec2> points = {}) {
  sim2d::Obstacle obstacle;
  obstacle.key = previewIdOf(EntityKind::Obstacle);
  obstacle.kind = kind;
  obstacle.points = std::move(points);
  return obstacle;
}

/// Draws walls as polylines, 0.1 m thick; a drag makes one straight wall.
class WallTool : public ShapeDrawingTool {
  Q_DECLARE_TR_FUNCTIONS(editor::WallTool)
 public:
  using ShapeDrawingTool::ShapeDrawingTool;

 protected:
  QString idleText() const override {
    return tr("Drag a wall, or click its corners one by one · Shift: 15° steps");
  }
  bool isClosed() const override { return false; }
  QString problemOf(const Corners& corners) const override {
    if (corners.size() < 2) {
      return tr("At least two corners are required");
    }
    double length = 0.0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      length += (corners[i] - corners[i - 1]).norm();
    }
    return length < kMinLength ? tr("Too short") : QString();
  }
  Entity shapeOf(const Corners& corners) const override {
    return obstacleOf(sim2d::ObstacleKind::Wall, corners);
  }
  Corners draggedCorners(const Vec2& from, const Vec2& to) const override { return {from, to}; }
};

/// Draws obstacles of any outline; a drag makes an axis-aligned rectangle.
class PolygonTool : public ShapeDrawingTool {
  Q_DECLARE_TR_FUNCTIONS(editor::PolygonTool)
 public:
  using ShapeDrawingTool::ShapeDrawingTool;

 protected:
  QString idleText() const override {
    return tr("Click the corners of an obstacle; click the first one to close it");
  }
  Entity shapeOf(const Corners& corners) const override {
    return obstacleOf(sim2d::ObstacleKind::Polygon, sim2d::polygonOutline(corners).points);
  }
};

/// Base of the tools that create an entity between two points of a drag. A click without a drag
/// creates nothing; Escape or the right button cancels.
class DragDrawingTool : public Tool {
 public:
  using Tool::Tool;

  void pressOther(Qt::MouseButton) override { cancel(); }
  void press(const CanvasMouse& mouse) override {
    from_ = snap(mouse, {});
    pressedAt_ = mouse.world;
    Q_EMIT statusTextChanged();
  }

  void move(const CanvasMouse& mouse) override {
    if (!from_) {
      snap(mouse, {});
      return;
    }
    if (!isDrag(pressedAt_, mouse)) {
      return;
    }
    const Vec2 to = endFor(*from_, mouse);
    if (const std::optional<Entity> entity = entityBetween(*from_, to)) {
      scene().setPreview({*entity});
    } else {
      scene().clearPreview();
    }
    marks().tag = {mouse.world, tagFor(*from_, to)};
  }

  void release(const CanvasMouse& mouse) override {
    if (!from_) {
      return;
    }
    const Vec2 from = *from_;
    const std::optional<Entity> entity =
        isDrag(pressedAt_, mouse) ? entityBetween(from, endFor(from, mouse)) : std::nullopt;
    cancel();
    if (entity) {
      addDrawnEntity(document(), *entity);
    }
  }

  void cancel() override {
    from_.reset();
    clearMarks();
  }

 protected:
  /// The entity between the points, without name and key; none = too small.
  virtual std::optional<Entity> entityBetween(const Vec2& from, const Vec2& to) const = 0;
  /// The end point of the drag; by default at multiples of 15 degrees with Shift.
  virtual Vec2 endFor(const Vec2& from, const CanvasMouse& mouse) const {
    return snap(mouse, {from});
  }
  virtual QString tagFor(const Vec2& from, const Vec2& to) const { return legText(from, to); }

 private:
  std::optional<Vec2> from_;
  Vec2 pressedAt_ = Vec2::Zero();
};

/// Draws boxes from corner to corner; squares with Shift.
class BoxTool : public DragDrawingTool {
  Q_DECLARE_TR_FUNCTIONS(editor::BoxTool)
 public:
  using DragDrawingTool::DragDrawingTool;
  QString statusText() const override {
    return tr("Drag a box from corner to corner · Shift makes a square");
  }

 protected:
  std::optional<Entity> entityBetween(const Vec2& from, const Vec2& to) const override {
    const Vec2 size = (to - from).cwiseAbs();
    if (size.minCoeff() < kMinLength) {
      return std::nullopt;
    }
    sim2d::Obstacle box = obstacleOf(sim2d::ObstacleKind::Box);
    box.pose.position = 0.5 * (from + to);
    box.length = size.x();
    box.width = size.y();
    return box;
  }

  Vec2 endFor(const Vec2& from, const CanvasMouse& mouse) const override {
    Vec2 to = snap(mouse, {});
    if (!mouse.modifiers.testFlag(Qt::ShiftModifier)) {
      return to;
    }
    const double side = (to - from).cwiseAbs().maxCoeff();
    return from +
           Vec2(std::copysign(side, to.x() - from.x()), std::copysign(side, to.y() - from.y()));
  }

  QString tagFor(const Vec2& from, const Vec2& to) const override {
    const Vec2 size = (to - from).cwiseAbs();
    return QStringLiteral("%1 × %2 m").arg(size.x(), 0, 'f', 2).arg(size.y(), 0, 'f', 2);
  }
};

/// Draws round obstacles from the centre to the rim.
class CircleTool : public DragDrawingTool {
  Q_DECLARE_TR_FUNCTIONS(editor::CircleTool)
 public:
  using DragDrawingTool::DragDrawingTool;
  QString statusText() const override {
    return tr("Drag from the centre of the circle to its edge");
  }

 protected:
  std::optional<Entity> entityBetween(const Vec2& from, const Vec2& to) const override {
    sim2d::Obstacle circle = obstacleOf(sim2d::ObstacleKind::Circle);
    circle.pose.position = from;
    circle.radius = std::round((to - from).norm() * 100.0) / 100.0;
    return circle.radius < kMinLength ? std::nullopt : std::optional<Entity>(circle);
  }

  QString tagFor(const Vec2& from, const Vec2& to) const override {
    return tr("radius %1 m").arg((to - from).norm(), 0, 'f', 2);
  }
};

/// Draws doors from the hinge to the other jamb, initially open.
class DoorTool : public DragDrawingTool {
  Q_DECLARE_TR_FUNCTIONS(editor::DoorTool)
 public:
  using DragDrawingTool::DragDrawingTool;
  QString statusText() const override {
    return tr("Drag a door from its hinge to the other jamb · Shift: 15° steps");
  }

 protected:
  std::optional<Entity> entityBetween(const Vec2& from, const Vec2& to) const override {
    sim2d::Door door;
    door.key = previewIdOf(EntityKind::Door);
    door.from = from;
    door.to = to;
    return (to - from).norm() < kNarrowestDoor ? std::nullopt : std::optional<Entity>(door);
  }
};

}  // namespace

void addShapeTool(ToolRegistry& to) {
  const QString shape = QStringLiteral("shape");
  to.add<WallTool>({70, QObject::tr("Wall"), QStringLiteral("tool-wall"), Qt::Key_W, shape});
  to.add<BoxTool>({80, QObject::tr("Box"), QStringLiteral("tool-box"), Qt::Key_O, shape});
  to.add<PolygonTool>(
      {90, QObject::tr("Polygon"), QStringLiteral("tool-polygon"), Qt::Key_Y, shape});
  to.add<CircleTool>({100, QObject::tr("Circle"), QStringLiteral("tool-circle"), Qt::Key_C, shape});
  to.add<DoorTool>({110, QObject::tr("Door"), QStringLiteral("tool-door"), Qt::Key_D});
}

}  // namespace editor
