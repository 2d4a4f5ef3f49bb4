#pragma once

#include <functional>

#include <QtWidgets>

#include "editor/document/PeopleEdits.h"
#include "editor/panels/behavior/RouteList.h"

namespace editor {

/// "Assign goals": people on the left, all goals in the middle, the route of the chosen people on
/// the right. Goals are added by button, double click, return or drag, and reordered by drag.
/// Changes are applied by OK as one undoable step.
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
  QLabel* whose_;
  QCheckBox* repeat_;
  QPushButton *add_ = nullptr, *remove_ = nullptr, *earlier_ = nullptr, *later_ = nullptr;
  QPushButton* clear_ = nullptr;
};

/// Opens the dialog over the window of `parent`; it deletes itself.
void openGoalAssignment(ScenarioDocument& document, const Theme& theme, QWidget* parent);

}  // namespace editor
