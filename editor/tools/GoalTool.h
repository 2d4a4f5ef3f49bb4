#pragma once

#include "editor/canvas/Tool.h"

namespace editor {

/// Click adds a goal; a click on a goal picks it up and the next one drops it, a drag moves it.
class GoalTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  QString name() const override { return tr("Goal"); }
  QString iconName() const override { return QStringLiteral("tool-goal"); }
  QKeySequence shortcut() const override { return QKeySequence(Qt::Key_G); }
  QString statusText() const override;
  void press(const CanvasMouse& mouse) override;
  void move(const CanvasMouse& mouse) override;
  void release(const CanvasMouse& mouse) override;
  void cancel() override;

 private:
  void preview(const Vec2& at);
  void drop(const Vec2& at);
  Vec2 placeOf(CanvasMouse mouse) const;
  std::optional<sim2d::GlobalGoal> held_;  // without a key in the document: a new one
  Vec2 from_ = Vec2::Zero();
  Vec2 grip_ = Vec2::Zero();  // from the cursor to the tip of the pin
  bool pressed_ = false;
  bool justPicked_ = false;
};

}  // namespace editor
