#pragma once

#include "editor/panels/PropertyPage.h"
#include "editor/panels/RouteEditor.h"

namespace editor {

/// One person, or several at once.
class PersonPage : public PropertyPage {
  Q_OBJECT
 public:
  PersonPage(ScenarioDocument& document, const Theme& theme, QWidget* parent = nullptr);
  void refresh() override;
  void setTheme(const Theme& theme) override;

 private:
  void addPersonSection();
  void addBodySection();
  void addGoalSection();
  void addReactionSection();
  void addForceSection();
  void addMoreSection();
  void addReactionNumber(const NumberKey& key, std::vector<sim2d::BehaviorType> of);
  void showRowsOf(sim2d::BehaviorType type);

  Theme theme_;
  ChoiceField* behavior_ = nullptr;
  FormSection* goals_ = nullptr;
  FormSection* reaction_ = nullptr;
  FormSection* forces_ = nullptr;
  RouteEditor* route_ = nullptr;
  std::vector<std::pair<QWidget*, std::vector<sim2d::BehaviorType>>> reactionRows_;
  std::vector<QWidget*> forceFields_;
};

}  // namespace editor
