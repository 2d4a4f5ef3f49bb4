#pragma once

#include <optional>

#include <QToolButton>

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
  void addDrawRows();
  void addGroupSection();
  void addAppearanceSection();
  void addMoreSection();
  void addFileRows(FormSection* section);
  void freeze();
  void showDraws(const std::vector<Entity>& shown);
  long long seed() const;  // whose draws are shown
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
  std::vector<QWidget*> drawnFields_;  // numbers of the reaction that a random mix draws
  NumberField* seed_ = nullptr;
  QWidget* drawLinks_ = nullptr;
  QToolButton* keepSeed_ = nullptr;
  std::optional<long long> ownSeed_;  // tried out here; none = the scenario's
  ChoiceField* group_ = nullptr;
  ChoiceField* skin_ = nullptr;
};

}  // namespace editor
