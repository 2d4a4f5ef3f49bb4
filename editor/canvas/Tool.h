#pragma once

#include "editor/canvas/AlignmentGuides.h"
#include "editor/canvas/MapScene.h"

namespace editor {

/// A mouse event on the canvas, world frame.
struct CanvasMouse {
  Vec2 world = Vec2::Zero();  // [m]
  Qt::MouseButton button = Qt::NoButton;
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  double pixelsPerMetre = 50.0;
};

constexpr double kSnapReachPx = 8.0;
constexpr double kGuideReachPx = 5.0;
constexpr double kSnapGrid = 0.5;              // [m]
constexpr double kSnapAngle = base::kPi / 12;  // 15 degrees

/// Options for snapping a drawn or moved point.
struct SnapRequest {
  std::optional<Vec2> anchor;          // With Shift: only multiples of 15 degrees from here.
  std::vector<EntityId> without = {};  // Entities whose points are ignored.
  std::vector<Vec2> more = {};         // Points of the current gesture.
  bool ontoPoints = true;              // False: grid and angles only.
  bool ontoWalls = true;               // Includes the walls of the map.
};

struct Snapped {
  Vec2 point = Vec2::Zero();
  bool isOnPoint = false;  // On a point of another entity, or on a wall.
};

/// A line of the current tool.
struct ToolLine {
  std::vector<Vec2> points;  // World frame.
  bool isClosed = false;     // Slightly filled if true.
  bool isBad = false;        // Invalid shape; drawn in the error colour.
  bool hasCorners = true;    // Small squares at the points.
};
/// A disc for a body that a tool would add.
struct ToolDot {
  Vec2 at = Vec2::Zero();
  double radius = 0.3;  // [m]
  QColor color;
  std::optional<double> heading;  // Drawn as a nose.
};

/// The marks that the current tool shows during a gesture.
struct ToolMarks {
  std::optional<std::pair<Vec2, Vec2>> band;  // Corners of a rubber band.
  std::vector<Vec2> line;                     // Dashed, with arrow heads.
  ToolLine outline;
  std::vector<Vec2> stroke;  // A line with the width `strokeWidth`.
  double strokeWidth = 0.1;  // [m]
  std::vector<ToolDot> dots;
  std::optional<std::pair<Vec2, Vec2>> arrow;
  std::optional<std::pair<Vec2, QString>> tag;  // A small dark box beside a point.
  std::optional<Vec2> snapMark;                 // Point of another entity that is snapped to.
  Alignment guides;                             // Of the entities being dragged.
};

/// The mouse behaviour on the canvas. One tool is active at a time. It shows previews through the
/// scene and modifies the document only by commands, one per gesture.
class Tool : public QObject {
  Q_OBJECT
 public:
  Tool(ScenarioDocument& document, MapScene& scene, QObject* parent);

  virtual QString statusText() const = 0;  // One line about the current effect of the mouse.
  virtual QCursor cursor() const { return Qt::CrossCursor; }

  virtual void activate() {}
  virtual void deactivate() { cancel(); }
  virtual void press(const CanvasMouse& mouse) = 0;    // Left button.
  virtual void release(const CanvasMouse& mouse) = 0;  // Left button.
  virtual void pressOther(Qt::MouseButton) {}
  virtual void move(const CanvasMouse& mouse) = 0;  // Also without a pressed button.
  virtual void doubleClick(const CanvasMouse&) {}
  virtual void cancel() = 0;  // Restores the state before the gesture.
  virtual bool keyPress(const QKeyEvent&) { return false; }  // Returns true if the key is handled.
  /// The option fields of the tool in one row, shown over the canvas while the tool is active; or
  /// null.
  virtual QWidget* makeOptions(QWidget*) { return nullptr; }

 Q_SIGNALS:
  void statusTextChanged();

 protected:
  ScenarioDocument& document() const { return document_; }
  MapScene& scene() const { return scene_; }
  ToolMarks& marks() const { return scene_.marks(); }
  /// The snapped mouse position (`snapped`). A point of another entity is marked on the canvas.
  Vec2 snap(const CanvasMouse& mouse, const SnapRequest& wish) const;
  Vec2 snapToGrid(const CanvasMouse& mouse) const;  // Snaps to the grid only.
  /// The alignment of dragged entities with others, which is shown on the canvas
  /// (`alignedOnCanvas`).
  Alignment align(const CanvasMouse& mouse, const Extent& moving,
                  const std::vector<EntityId>& without) const;
  /// A dragged point: as `snap`, and aligned with other entities where it is not on a point or
  /// wall.
  Vec2 snapAligned(const CanvasMouse& mouse, const SnapRequest& wish) const;
  void clearMarks();  // Removes the marks of the gesture and emits `statusTextChanged`.

 private:
  ScenarioDocument& document_;
  MapScene& scene_;
};

/// Snaps in this order of precedence: none with Alt, angle with Shift, point of another entity
/// within 8 px, half metres with Ctrl, corner or edge of the map's walls within 8 px, half metres
/// if grid snapping is on, else whole centimetres. The canvas options enable points, walls and
/// grid.
Snapped snapped(const MapScene& scene, const CanvasMouse& mouse, const SnapRequest& wish = {});

/// The point on the border of the map's walls nearest to `world` within `reach` [m]: a corner if
/// one is within reach, else any point of an edge. Cell steps along a slanted wall do not count as
/// corners. Examines only nearby cells.
std::optional<Vec2> nearestOnWalls(const sim2d::OccupancyGrid& grid, const Vec2& world,
                                   double reach);

/// The box by which an entity is aligned: its bounding box; for bodies and for obstacles without
/// horizontal edges the centre. None for the settings.
std::optional<Extent> guideBoxOf(const Entity& entity);
/// The bounding box of the guide boxes of all selected entities; none: there are none.
std::optional<Extent> guideBoxOfSelection(const ScenarioDocument& document);
/// The alignment of a dragged bounding box with the nearest visible entities other than `without`.
/// None with Alt or Ctrl, or if the canvas options disable it.
Alignment alignedOnCanvas(const MapScene& scene, const CanvasMouse& mouse, const Extent& moving,
                          const std::vector<EntityId>& without);

/// The points of an entity that others snap to: corners, ends, centres; none for people.
std::vector<Vec2> snapPointsOf(const Entity& entity);
/// The heading rounded to multiples of `step` [rad].
double snappedAngle(double heading, double step = kSnapAngle);

constexpr double kDragPx = 4.0;  // Shorter movements are clicks.
bool isDrag(const Vec2& from, const CanvasMouse& mouse);
QString placeText(const Vec2& world);               // "6.30, 6.90 m"
QString headingText(double heading);                // "-28.0°"
QString legText(const Vec2& from, const Vec2& to);  // "2.35 m · 45.0°"

}  // namespace editor
