#pragma once

#include "editor/canvas/Tool.h"

namespace editor {

/// Removes what is clicked, or all that a sweep crosses, with one command; routes and sources
/// follow. Areas lie under everything and go by a click only.
class EraserTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  QString name() const override { return tr("Eraser"); }
  QString iconName() const override { return QStringLiteral("tool-eraser"); }
  QKeySequence shortcut() const override { return QKeySequence(Qt::Key_E); }
  QString statusText() const override;
  void press(const CanvasMouse& mouse) override;
  void move(const CanvasMouse& mouse) override;
  void release(const CanvasMouse& mouse) override;
  void cancel() override;

 private:
  void sweepTo(const Vec2& world);
  void take(EntityId id);
  std::vector<EntityId> taken_;
  std::optional<EntityId> pressedOn_;  // while the button is down; may be none
  Vec2 from_ = Vec2::Zero();           // of the gesture
  Vec2 at_ = Vec2::Zero();             // as far as swept
  bool sweeping_ = false;
};

}  // namespace editor
