#pragma once

#include <optional>

#include <QToolButton>

#include "editor/panels/PropertyPage.h"
#include "editor/panels/RouteEditor.h"

namespace editor {

inline const sim2d::Human& personOf(const Entity& entity) {
  return std::get<sim2d::Human>(entity);
}
inline sim2d::Human& personOf(Entity& entity) {
  return std::get<sim2d::Human>(entity);
}
sim2d::BehaviorType behaviorOf(const Entity& entity);  // Regular when left out

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
  long long seed() const override;

  Theme theme_;
  ChoiceField* behavior_ = nullptr;
  FormSection* goals_ = nullptr;
  FormSection* reaction_ = nullptr;
  FormSection* forces_ = nullptr;
  RouteEditor* route_ = nullptr;
  NumberField* seed_ = nullptr;
  QWidget* drawLinks_ = nullptr;
  QToolButton* keepSeed_ = nullptr;
  std::optional<long long> ownSeed_;  // tried out here; none = the scenario's
  ChoiceField* group_ = nullptr;
  ChoiceField* skin_ = nullptr;
};

}  // namespace editor
