#pragma once

#include "editor/canvas/Tool.h"

namespace editor {

/// Base of the tools that make something from one point to another by a drag. A click without a
/// drag makes nothing, Escape or the right button drops the gesture.
class DragDrawing : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  void press(const CanvasMouse& mouse) override;
  void move(const CanvasMouse& mouse) override;
  void release(const CanvasMouse& mouse) override;
  void cancel() override;

 protected:
  /// The entity between the points, without name and key in the document; none = too small.
  virtual std::optional<Entity> spanned(const Vec2& from, const Vec2& to) const = 0;
  /// Where the drag ends; by default on angles of 15 degrees from the start with Shift.
  virtual Vec2 endFor(const Vec2& from, const CanvasMouse& mouse) const;
  virtual QString tagFor(const Vec2& from, const Vec2& to) const { return legText(from, to); }
  virtual QString undoText() const = 0;

 private:
  std::optional<Vec2> from_;
  Vec2 pressedAt_ = Vec2::Zero();
};

/// The key of a thing that is not in the document yet.
EntityId ghostOf(EntityKind kind);
/// Adds something with a name that begins with `stem`, and selects it.
void addDrawn(ScenarioDocument& document, Entity value, const std::string& stem,
              const QString& undoText);

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
  bool isOnFirst(const Vec2& point, double pixelsPerMetre) const;
  void addCorner(const Vec2& point);
  void show();
  void finish(Corners corners);

  Corners corners_;
  Vec2 cursor_ = Vec2::Zero();
  Vec2 pressedAt_ = Vec2::Zero();
  QString problem_;  // of the attempt to end
  bool pressed_ = false;
};

constexpr double kLeastLength = 0.05;  // of a side [m]
constexpr double kLeastArea = 0.01;    // [m²]

}  // namespace editor
