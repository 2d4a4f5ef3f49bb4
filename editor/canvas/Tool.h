#pragma once

#include <QCursor>
#include <QKeyEvent>
#include <QObject>
#include <QWidget>

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
constexpr double kSnapGrid = 0.5;              // [m]
constexpr double kSnapAngle = base::kPi / 12;  // 15 degrees

/// What a point that is drawn or moved may come to lie on.
struct SnapWish {
  std::optional<Vec2> anchor;          // with Shift: only at multiples of 15 degrees from here
  std::vector<EntityId> without = {};  // entities whose points do not count
  std::vector<Vec2> more = {};         // points of the gesture itself
  bool ontoPoints = true;              // false: grid and angles only
  bool ontoWalls = true;               // and the walls of the map
};

struct Snapped {
  Vec2 point = Vec2::Zero();
  bool isOnPoint = false;  // on one of another entity, or on a wall
};

/// A line of the current tool.
struct ToolLine {
  std::vector<Vec2> points;  // world
  bool isClosed = false;     // then slightly filled
  bool isBad = false;        // cannot become anything: in the colour of errors
  bool hasCorners = true;    // small squares at its points
};
/// Somebody or something that a tool would make: a disc.
struct ToolDot {
  Vec2 at = Vec2::Zero();
  double radius = 0.3;  // [m]
  QColor color;
  std::optional<double> heading;  // a nose
};

/// What the current tool shows while a gesture lasts.
struct ToolMarks {
  std::optional<std::pair<Vec2, Vec2>> band;  // corners of a rubber band
  std::vector<Vec2> line;                     // dashed, with arrow heads
  ToolLine outline;
  std::vector<Vec2> stroke;  // a line as wide as that:
  double strokeWidth = 0.1;  // [m]
  std::vector<ToolDot> dots;
  std::optional<std::pair<Vec2, Vec2>> arrow;
  std::optional<std::pair<Vec2, QString>> tag;  // a small dark box beside a point
  std::optional<Vec2> snapMark;                 // the point of another entity that holds
};

/// What the mouse does on the canvas. One is active at a time; it shows previews through the scene
/// and writes to the document only by commands, one per gesture.
class Tool : public QObject {
  Q_OBJECT
 public:
  Tool(ScenarioDocument& document, MapScene& scene, QObject* parent);

  virtual QString statusText() const = 0;  // what the mouse does now, one line
  virtual QCursor cursor() const { return Qt::CrossCursor; }

  virtual void activate() {}
  virtual void deactivate() { cancel(); }
  virtual void press(const CanvasMouse& mouse) = 0;    // the left button
  virtual void release(const CanvasMouse& mouse) = 0;  // the left button
  virtual void pressOther(Qt::MouseButton) {}
  virtual void move(const CanvasMouse& mouse) = 0;  // also without a button
  virtual void doubleClick(const CanvasMouse&) {}
  virtual void cancel() = 0;  // leaves the document as it was before the gesture
  virtual bool keyPress(const QKeyEvent&) { return false; }  // true = used
  /// Settings of the tool, one row, shown over the canvas while it is the current one; or none.
  virtual QWidget* makeOptions(QWidget*) { return nullptr; }

 Q_SIGNALS:
  void statusTextChanged();

 protected:
  ScenarioDocument& document() const { return document_; }
  MapScene& scene() const { return scene_; }
  ToolMarks& marks() const { return scene_.marks(); }
  /// Where the mouse comes to lie (`snapped`); a point of another entity is marked on the canvas.
  Vec2 snap(const CanvasMouse& mouse, const SnapWish& wish) const;
  Vec2 snapToGrid(const CanvasMouse& mouse) const;  // and to nothing else
  void clearMarks();  // what a gesture showed goes; `statusTextChanged`

 private:
  ScenarioDocument& document_;
  MapScene& scene_;
};

/// In this order: anywhere with Alt, on an angle with Shift, on a point of another entity within 8
/// px, on half metres with Ctrl, on a corner or edge of the map's walls within 8 px, on half metres
/// while the grid holds, else on whole centimetres. Points, walls and grid as the options of the
/// canvas say.
Snapped snapped(const MapScene& scene, const CanvasMouse& mouse, const SnapWish& wish = {});

/// The place on the border of the map's walls nearest to `world`, none beyond `reach` [m]: a corner
/// where there is one within reach, else anywhere on an edge. The steps that cells make along a
/// slanted wall are no corners. Looks only at the cells near by.
std::optional<Vec2> nearestOnWalls(const sim2d::OccupancyGrid& grid, const Vec2& world,
                                   double reach);

/// The points of an entity that others snap to: corners, ends, centres; none of people.
std::vector<Vec2> snapPointsOf(const Entity& entity);
/// The heading in steps, of 15 degrees or others [rad].
double snappedAngle(double heading, double step = kSnapAngle);

constexpr double kDragPx = 4.0;  // less is a click
bool isDrag(const Vec2& from, const CanvasMouse& mouse);
QString placeText(const Vec2& world);               // "6.30, 6.90 m"
QString headingText(double heading);                // "-28.0°"
QString legText(const Vec2& from, const Vec2& to);  // "2.35 m · 45.0°"

}  // namespace editor
