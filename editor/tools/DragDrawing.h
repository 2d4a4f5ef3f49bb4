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

}  // namespace editor
