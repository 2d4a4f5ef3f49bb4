#pragma once

#include "editor/canvas/Tool.h"
#include "editor/document/Handles.h"

namespace editor {

/// Click selects, drag moves, handles turn and size, a drag from empty ground selects what lies
/// inside; arrows nudge. During a run it only selects.
class SelectTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  QString statusText() const override;
  QCursor cursor() const override { return cursor_; }
  void deactivate() override;  // the selection stays for the next tool
  void press(const CanvasMouse& mouse) override;
  void move(const CanvasMouse& mouse) override;
  void release(const CanvasMouse& mouse) override;
  /// On an edge of a selected outline: a new corner; on a corner: away with it.
  void doubleClick(const CanvasMouse& mouse) override;
  void cancel() override;
  bool keyPress(const QKeyEvent& event) override;

 private:
  enum class Gesture { None, Pressed, Moving, Handle, Band };
  void hover(const CanvasMouse& mouse);
  void pressInRun(const CanvasMouse& mouse);
  bool grabHandle(const CanvasMouse& mouse);
  void grabRobotGoal(const CanvasMouse& mouse);
  Vec2 deltaFor(const CanvasMouse& mouse) const;
  void previewMove(const CanvasMouse& mouse);
  void previewHandle(const CanvasMouse& mouse);
  Vec2 handleTarget(const Entity& entity, const CanvasMouse& mouse) const;
  QString handleText(const Entity& before, const Vec2& to) const;
  void selectBand(const CanvasMouse& mouse);
  void end();
  bool nudge(const QKeyEvent& event);
  void setCursor(Qt::CursorShape shape);

  Gesture gesture_ = Gesture::None;
  Vec2 from_ = Vec2::Zero();
  EntityId grabbed_;
  Handle handle_;
  std::optional<Entity> pulled_;
  Qt::CursorShape cursor_ = Qt::ArrowCursor;
  bool deselectOnRelease_ = false;
};

}  // namespace editor
