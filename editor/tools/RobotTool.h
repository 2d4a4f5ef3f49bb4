#pragma once

#include "editor/canvas/Tool.h"

namespace editor {

/// Press and drag sets where the robot starts and looks; the next click is its goal (a point, or a
/// goal of the map). Changes the selected robot, else the first one; Shift makes another.
class RobotTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  QString name() const override { return tr("Robot"); }
  QString iconName() const override { return QStringLiteral("tool-robot"); }
  QKeySequence shortcut() const override { return QKeySequence(Qt::Key_B); }
  QString statusText() const override;
  void activate() override { waitsForGoal_ = {}; }
  void press(const CanvasMouse& mouse) override;
  void move(const CanvasMouse& mouse) override;
  void release(const CanvasMouse& mouse) override;
  void cancel() override;

 private:
  sim2d::Robot robotFor(const CanvasMouse& mouse) const;
  void setGoal(const CanvasMouse& mouse);
  void endGesture();
  std::optional<sim2d::Robot> placing_;
  EntityId waitsForGoal_;  // the robot whose start was just set
  Vec2 from_ = Vec2::Zero();
};

}  // namespace editor
