#pragma once

#include <map>
#include <optional>

#include <QtWidgets>

#include "app/run/Nav2Robots.h"
#include "editor/panels/properties/PropertyPage.h"
#include "sim2d/world/Registries.h"

namespace editor {

/// Page for one or several people.
class PersonPage : public PropertyPage {
  Q_DECLARE_TR_FUNCTIONS(editor::PersonPage)
 public:
  PersonPage(ScenarioDocument& document, const Theme& theme);
  void setTheme(const Theme& theme) override;

 private:
  void addPersonSection();
  void addGoalSection();
  void addReactionSection();
  void addForceSection();
  void addDrawRows();
  void addGroupSection();
  void addAppearanceSection();
  void addMoreSection();
  void addTreeRow(FormSection* section);
  void showTreeRow(FormSection& section);
  void showBehavior(const std::vector<Entity>& shown);
  long long seed() const override;

  Theme theme_;
  ChoiceField* behavior_ = nullptr;
  FormSection* reaction_ = nullptr;
  FormSection* forces_ = nullptr;
  NumberField* seed_ = nullptr;
  QWidget* drawLinks_ = nullptr;
  QLabel* customTreeLabel_ = nullptr;
  QToolButton* regenerateTree_ = nullptr;
  QToolButton* keepSeed_ = nullptr;
  std::optional<long long> ownSeed_;  // Tried out in the page; none = that of the scenario.
};

class RobotPicture;

/// Page for robots: a picture of the body, then type, planner, start and goal. The parameters of
/// the chosen planner, sensors and limits are collapsible sections.
class RobotPage : public PropertyPage {
  Q_DECLARE_TR_FUNCTIONS(editor::RobotPage)
 public:
  explicit RobotPage(ScenarioDocument& document,
                     const sim2d::FieldTables& tables = sim2d::fieldTables(),
                     const sim2d::Registries& registries = app::builtinRegistries());
  void setTheme(const Theme& theme) override;

 private:
  void addTypeRows(FormSection* section, const sim2d::Registries& registries);
  void addPlannerRows(FormSection* section, const sim2d::Registries& registries);
  void addNav2Section();
  void addGoalSection();
  template <class Part>
  void addPart(const QString& title, const sim2d::FieldTables& tables,
               const std::map<std::string, FieldOptions>& looks = {});

  RobotPicture* picture_;
  QToolButton* source_ = nullptr;
};

/// Page for the scenario settings; shown if nothing is selected. The parameters of the chosen
/// pedestrian model have rows.
class SettingsPage : public PropertyPage {
  Q_DECLARE_TR_FUNCTIONS(editor::SettingsPage)
 public:
  explicit SettingsPage(ScenarioDocument& document,
                        const sim2d::Registries& registries = app::builtinRegistries());

 private:
  void addRunSection();
  void addPeopleSection(const sim2d::Registries& registries);
  void addVariationSection();
  void addCardSection();
  void addModelSection(const sim2d::Registries& registries);
  void addFileSection();
  void addMeasureSection();
};

/// One page per kind.
std::map<EntityKind, PropertyPage*> entityPages(ScenarioDocument& document, const Theme& theme);

}  // namespace editor
