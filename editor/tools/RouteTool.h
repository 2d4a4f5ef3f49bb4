#pragma once

#include "editor/canvas/Tool.h"

namespace editor {

/// Click goals in the order in which the selected people are to visit them. Enter, a double click
/// or another tool takes the route over; Escape drops it, Backspace takes the last goal back.
class RouteTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  QString name() const override { return tr("Route"); }
  QString iconName() const override { return QStringLiteral("tool-route"); }
  QKeySequence shortcut() const override { return QKeySequence(Qt::Key_R); }
  QString statusText() const override;
  void activate() override { cancel(); }
  void deactivate() override { commit(); }
  void press(const CanvasMouse& mouse) override;
  void move(const CanvasMouse& mouse) override;
  void release(const CanvasMouse&) override {}
  void doubleClick(const CanvasMouse&) override { commit(); }
  void cancel() override;
  bool keyPress(const QKeyEvent& event) override;

 private:
  std::vector<EntityId> walkers() const;  // selected people and robots
  void preview();
  void commit();
  std::vector<int> goals_;
};

}  // namespace editor
