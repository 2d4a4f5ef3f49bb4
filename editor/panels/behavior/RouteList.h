#pragma once

#include <vector>

#include <QtWidgets>

#include "editor/look/Theme.h"
#include "sim2d/scenario/Scenario.h"

namespace editor {

/// A list that shows a hint while it is empty.
class HintList : public QListWidget {
  Q_OBJECT
 public:
  HintList(const Theme& theme, const QString& name, QWidget* parent);
  void setHint(const QString& hint);
  QString hint() const { return hint_; }
  std::vector<int> selectedRows() const;  // From top to bottom.

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString hint_;
};

/// A column with a heading above a list or form of a dialog.
QVBoxLayout* titledColumn(const QString& title, const Theme& theme, QWidget* content);

/// A source list of goals: goals can be dragged out, and return adds the selected ones.
class GoalList : public HintList {
  Q_OBJECT
 public:
  GoalList(const Theme& theme, const QString& name, QWidget* parent);
  void addGoal(const sim2d::GlobalGoal* goal, int number, const QString& sideText);
  std::vector<int> selectedGoals() const;  // From top to bottom.
  std::vector<int> goals() const;

 Q_SIGNALS:
  void addRequested();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QList<QListWidgetItem*> items) const override;

 private:
  Theme theme_;
};

/// Goals in visiting order; dragging reorders them or inserts goals of a GoalList.
class RouteList : public GoalList {
  Q_OBJECT
 public:
  RouteList(const Theme& theme, const QString& name, QWidget* parent);
  void showRoute(const std::vector<int>& route, const sim2d::Scenario& scenario);
  void removeSelected();
  void moveSelected(int by);  // -1 = earlier, 1 = later

 Q_SIGNALS:
  void edited(const std::vector<int>& route);
  void dropped(const std::vector<int>& goals, int row);  // From another list.

 protected:
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void moveRows(const std::vector<int>& rows, int before);
};

}  // namespace editor
