#pragma once

#include "editor/panels/PropertyPage.h"
#include "editor/panels/RouteEditor.h"

namespace editor {

class RobotPage : public PropertyPage {
  Q_OBJECT
 public:
  explicit RobotPage(ScenarioDocument& document, QWidget* parent = nullptr,
                     const sim2d::FieldTables& tables = sim2d::fieldTables());

 private:
  void addGoalSection();
};

class GoalPage : public PropertyPage {
  Q_OBJECT
 public:
  explicit GoalPage(ScenarioDocument& document, QWidget* parent = nullptr);

 private:
  QString visitorsOf(int goal) const;
};

class ObstaclePage : public PropertyPage {
  Q_OBJECT
 public:
  explicit ObstaclePage(ScenarioDocument& document, QWidget* parent = nullptr);
  void refresh() override;

 private:
  FormSection* section_ = nullptr;
};

class DoorPage : public PropertyPage {
  Q_OBJECT
 public:
  explicit DoorPage(ScenarioDocument& document, QWidget* parent = nullptr);
};

class AreaPage : public PropertyPage {
  Q_OBJECT
 public:
  explicit AreaPage(ScenarioDocument& document, QWidget* parent = nullptr);
  void refresh() override;

 private:
  FormSection* source_ = nullptr;
};

/// What belongs to the scenario as a whole; shown when nothing is selected.
class SettingsPage : public PropertyPage {
  Q_OBJECT
 public:
  explicit SettingsPage(ScenarioDocument& document, QWidget* parent = nullptr);

 private:
  void addRunSection();
  void addPeopleSection();
  void addFileSection();
  void addMeasureSection();
};

}  // namespace editor
