#pragma once

#include <functional>

#include <QGridLayout>
#include <QToolButton>

#include "editor/canvas/MapScene.h"
#include "editor/look/Fields.h"
#include "editor/tools/Crowd.h"
#include "editor/tools/OptionsRow.h"

namespace editor {

/// A button that shows the shares of the behaviours as a bar and opens fields for them.
class MixButton : public QToolButton {
  Q_OBJECT
 public:
  MixButton(CrowdRecipe& recipe, const MapScene& scene, QWidget* parent);

 Q_SIGNALS:
  void mixChanged();

 private:
  QWidget* makeFields();
  void addSeed(QGridLayout& grid);
  void showBar();
  CrowdRecipe& recipe_;
  const MapScene& scene_;
};

/// Fields for a recipe, which has to outlive them; `changed` is called after each change.
void addRecipeFields(OptionsRow& row, CrowdRecipe& recipe, const MapScene& scene,
                     const std::function<void()>& changed);
/// A narrow field for a number that a tool keeps.
NumberField* addNumber(OptionsRow& row, const QString& label, const NumberField::Range& range,
                       const QString& unit, double value,
                       const std::function<void(double)>& changed);

}  // namespace editor
