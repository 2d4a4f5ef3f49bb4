#pragma once

#include <QCursor>
#include <QKeyEvent>
#include <QObject>
#include <QWidget>

#include "editor/document/ScenarioDocument.h"

namespace editor {

class MapScene;
struct SnapWish;

/// A mouse event on the canvas, world frame.
struct CanvasMouse {
  Vec2 world = Vec2::Zero();  // [m]
  Qt::MouseButton button = Qt::NoButton;
  Qt::MouseButtons buttons = Qt::NoButton;
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  double pixelsPerMetre = 50.0;
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
  virtual void press(const CanvasMouse& mouse) = 0;
  virtual void move(const CanvasMouse& mouse) = 0;  // also without a button
  virtual void release(const CanvasMouse& mouse) = 0;
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
  /// Where the mouse comes to lie (Snap.h); a point of another entity is marked on the canvas.
  Vec2 snap(const CanvasMouse& mouse, const SnapWish& wish) const;
  Vec2 snapToGrid(const CanvasMouse& mouse) const;  // and to nothing else
  void clearMarks();  // what a gesture showed goes; `statusTextChanged`

 private:
  ScenarioDocument& document_;
  MapScene& scene_;
};

constexpr double kDragPx = 4.0;  // less is a click
bool isDrag(const Vec2& from, const CanvasMouse& mouse);
QString placeText(const Vec2& world);               // "6.30, 6.90 m"
QString headingText(double heading);                // "-28.0°"
QString legText(const Vec2& from, const Vec2& to);  // "2.35 m · 45.0°"

}  // namespace editor
