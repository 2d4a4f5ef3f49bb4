#pragma once

#include "editor/canvas/Tool.h"

namespace editor {

/// The key of a thing that is not in the document yet.
EntityId ghostOf(EntityKind kind);
/// Adds an obstacle, door or area named after its kind, and selects it.
void addDrawn(ScenarioDocument& document, Entity value);

/// Base of the tools that draw by corners. Each click sets one; Enter, a double click, the right
/// button or a click on the first corner ends the shape, Backspace takes the last corner back,
/// Escape drops all. A drag from the first corner makes the simplest shape at once. With Shift,
/// legs run at multiples of 15 degrees.
class CornerDrawing : public Tool {
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
  virtual QString idleText() const = 0;  // the status before the first corner
  virtual bool isClosed() const { return true; }
  /// What keeps the corners from becoming a shape; empty = nothing.
  virtual QString problemOf(const Corners& corners) const;
  /// Shows what the corners would make; `problemOf` has found nothing.
  virtual void preview(const Corners& corners) = 0;
  /// Makes it: one command. Preview and corners are gone by then.
  virtual void make(const Corners& corners) = 0;
  /// What a drag makes: a rectangle, for lines the line itself.
  virtual Corners dragged(const Vec2& from, const Vec2& to) const;

 private:
  Vec2 cursorFor(const CanvasMouse& mouse) const;
  void addCorner(const Vec2& point);
  void show();
  void finish(const Corners& corners);

  Corners corners_;
  Vec2 cursor_ = Vec2::Zero();
  Vec2 pressedAt_ = Vec2::Zero();
  QString problem_;  // of the attempt to end
  bool pressed_ = false;
};

/// Base of those that draw one thing.
class ShapeDrawing : public CornerDrawing {
  Q_OBJECT
 public:
  using CornerDrawing::CornerDrawing;

 protected:
  /// What the corners make, without a name.
  virtual Entity shapeOf(const Corners& corners) const = 0;
  void preview(const Corners& corners) override { scene().setPreview({shapeOf(corners)}); }
  void make(const Corners& corners) override { addDrawn(document(), shapeOf(corners)); }
};

}  // namespace editor
