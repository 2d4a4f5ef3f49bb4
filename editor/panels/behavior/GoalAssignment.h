#pragma once

#include <functional>
#include <vector>

#include <QtWidgets>

#include "editor/document/PeopleEdits.h"
#include "editor/look/Form.h"
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

/// "Assign goals": people on the left, all goals in the middle, the route of the chosen people on
/// the right. People and goals that are selected on the map are chosen at first. Goals are added by
/// button, double click, return or drag, and reordered by drag. Changes are applied by OK as one
/// undoable step.
class GoalAssignment : public QDialog {
  Q_OBJECT
 public:
  GoalAssignment(ScenarioDocument& document, const Theme& theme, QWidget* parent = nullptr);

  void accept() override;
  QListWidget& people() const { return *people_; }
  GoalList& goals() const { return *goals_; }
  RouteList& route() const { return *route_; }

 private:
  QWidget* makeMiddle();
  QWidget* makeRouteColumn();
  void fillLists();
  void loadSelection();
  void addSelectedGoals();
  void showRoute();
  void showPeople();
  void add(const std::vector<int>& goals, int row);
  std::vector<EntityId> chosen() const;
  QPushButton* moveButton(const QString& icon, const QString& says,
                          const std::function<void()>& action);

  ScenarioDocument& document_;
  Theme theme_;
  RoutePlan plan_;
  HintList* people_;
  GoalList* goals_;
  RouteList* route_;
  QLabel* whose_ = headingLabel({}, theme_.font(9.5, QFont::DemiBold), this);
  QCheckBox* repeat_ = new QCheckBox(tr("Repeat after the last"), this);
  QPushButton *add_ = nullptr, *remove_ = nullptr, *earlier_ = nullptr, *later_ = nullptr;
  QPushButton* clear_ = nullptr;
};

/// Opens the dialog over the window of `parent`; it deletes itself.
void openGoalAssignment(ScenarioDocument& document, const Theme& theme, QWidget* parent);

}  // namespace editor
