#pragma once

#include <functional>

#include <QCheckBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>

#include "editor/document/RoutePlan.h"
#include "editor/panels/RouteList.h"

namespace editor {

/// "Assign goals": people at the left, all goals in the middle, the route of the people that are
/// chosen at the right. Goals go over by button, double click, return or drag, and are put in order
/// by drag. Nothing changes before OK, and all of it is one undoable step.
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
  void takeSelection();
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
