#pragma once

#include <optional>

#include <QToolButton>

#include "editor/panels/PropertyPage.h"

namespace editor {

/// One person, or several at once.
class PersonPage : public PropertyPage {
 public:
  PersonPage(ScenarioDocument& document, const Theme& theme, QWidget* parent = nullptr);
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
  void showBehavior(const std::vector<Entity>& shown);
  long long seed() const override;

  Theme theme_;
  ChoiceField* behavior_ = nullptr;
  FormSection* reaction_ = nullptr;
  FormSection* forces_ = nullptr;
  NumberField* seed_ = nullptr;
  QWidget* drawLinks_ = nullptr;
  QToolButton* keepSeed_ = nullptr;
  std::optional<long long> ownSeed_;  // tried out here; none = the scenario's
};

}  // namespace editor
