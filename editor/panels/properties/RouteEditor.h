#pragma once

#include <vector>

#include <QWidget>

#include "editor/document/ScenarioDocument.h"
#include "editor/look/DeferredActions.h"

namespace editor {

/// The goals of a person or robot as chips in visiting order. The menu of a chip selects its goal,
/// moves it or removes it, as Delete does; "+ Add" offers all goals.
class RouteEditor : public QWidget {
  Q_OBJECT
 public:
  explicit RouteEditor(ScenarioDocument& document, QWidget* parent = nullptr);

  void show(const std::vector<int>& goals);
  const std::vector<int>& goals() const { return goals_; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;

 Q_SIGNALS:
  void edited(const std::vector<int>& goals);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  class Chip;
  void rebuild();
  int place(int width, bool apply) const;
  void offerGoals(QWidget* button);
  void offerMoves(QWidget* chip, int index);
  bool has(int index) const { return index >= 0 && index < static_cast<int>(goals_.size()); }
  void removeGoal(int index);
  void moveGoal(int from, int to);

  ScenarioDocument& document_;
  std::vector<int> goals_;
  std::vector<QWidget*> parts_;
  PanelMenu menu_;  // Menu of a chip or the button.
};

}  // namespace editor
