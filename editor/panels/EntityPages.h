#pragma once

#include "editor/panels/PropertyPage.h"
#include "sim2d/world/Registries.h"

namespace editor {

/// The parameters of a planner have rows while a robot that has this planner is shown.
class RobotPage : public PropertyPage {
 public:
  explicit RobotPage(ScenarioDocument& document, QWidget* parent = nullptr,
                     const sim2d::FieldTables& tables = sim2d::fieldTables(),
                     const sim2d::Registries& registries = sim2d::programRegistries());

 private:
  void addGoalSection();
};

class GoalPage : public PropertyPage {
 public:
  explicit GoalPage(ScenarioDocument& document, QWidget* parent = nullptr);

 private:
  QString visitorsOf(int goal) const;
};

class ObstaclePage : public PropertyPage {
 public:
  explicit ObstaclePage(ScenarioDocument& document, QWidget* parent = nullptr);
};

class DoorPage : public PropertyPage {
 public:
  explicit DoorPage(ScenarioDocument& document, QWidget* parent = nullptr);
};

class AreaPage : public PropertyPage {
 public:
  explicit AreaPage(ScenarioDocument& document, QWidget* parent = nullptr);
};

/// What belongs to the scenario as a whole; shown when nothing is selected. The parameters of the
/// chosen pedestrian model have rows.
class SettingsPage : public PropertyPage {
 public:
  explicit SettingsPage(ScenarioDocument& document, QWidget* parent = nullptr,
                        const sim2d::Registries& registries = sim2d::programRegistries());

 private:
  void addRunSection();
  void addPeopleSection(const sim2d::Registries& registries);
  void addModelSection(const sim2d::Registries& registries);
  void addFileSection();
  void addMeasureSection();
};

}  // namespace editor
