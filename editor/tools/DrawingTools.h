#pragma once

#include "editor/canvas/Tool.h"

namespace editor {

/// The key of an entity that is not in the document yet.
EntityId previewIdOf(EntityKind kind);
/// Adds an obstacle, door or area named after its kind, and selects it.
void addDrawnEntity(ScenarioDocument& document, Entity value);

/// Base of the tools that draw by corners. Each click adds a corner; Enter, a double click, the
/// right button or a click on the first corner completes the shape, Backspace removes the last
/// corner, Escape cancels. A drag from the first corner makes the simplest shape directly. With
/// Shift, edges are limited to multiples of 15 degrees.
class CornerDrawingTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  QString statusText() const override;
  void press(const CanvasMouse& mouse) override;
  void pressOther(Qt::MouseButton button) override;
  void move(const CanvasMouse& mouse) override;
  void release(const CanvasMouse& mouse) override;
  void doubleClick(const CanvasMouse&) override { finish(corners_); }
  void cancel() override;
  bool keyPress(const QKeyEvent& event) override;

 protected:
  using Corners = std::vector<Vec2>;
  virtual QString idleText() const = 0;  // Status text before the first corner.
  virtual bool isClosed() const { return true; }
  /// The reason why the corners do not form a valid shape; empty = valid.
  virtual QString problemOf(const Corners& corners) const;
  /// Shows the result for valid corners.
  virtual void preview(const Corners& corners) = 0;
  /// Creates the result with one command. Preview and corners are already cleared.
  virtual void make(const Corners& corners) = 0;
  void redraw() {  // Shows the current corners again, if there are any.
    if (!corners_.empty()) {
      show();
    }
  }
  /// The corners of a shape made by a drag: a rectangle, or the line itself for lines.
  virtual Corners draggedCorners(const Vec2& from, const Vec2& to) const;

 private:
  Vec2 cursorFor(const CanvasMouse& mouse) const;
  void addCorner(const Vec2& point);
  void show();
  void finish(const Corners& corners);

  Corners corners_;
  Vec2 cursor_ = Vec2::Zero();
  Vec2 pressedAt_ = Vec2::Zero();
  QString problem_;  // Reason of the last failed completion.
  bool pressed_ = false;
};

/// Base of the tools that draw one entity.
class ShapeDrawingTool : public CornerDrawingTool {
  Q_OBJECT
 public:
  using CornerDrawingTool::CornerDrawingTool;

 protected:
  /// The entity for the corners, without a name.
  virtual Entity shapeOf(const Corners& corners) const = 0;
  void preview(const Corners& corners) override { scene().setPreview({shapeOf(corners)}); }
  void make(const Corners& corners) override { addDrawnEntity(document(), shapeOf(corners)); }
};

}  // namespace editor
