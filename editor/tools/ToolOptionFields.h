#pragma once

#include "editor/canvas/MapScene.h"
#include "editor/look/Fields.h"
#include "editor/tools/CrowdGenerator.h"

namespace editor {

/// The option fields of a tool in one row, with labels before them.
class OptionsRow : public QWidget {
 public:
  explicit OptionsRow(QWidget* parent);
  void add(const QString& label, QWidget* field);

 private:
  QHBoxLayout* layout_;
};

/// Fields for a recipe, which must outlive them; `changed` is called after each change.
void addRecipeFields(OptionsRow& row, CrowdRecipe& recipe, const MapScene& scene,
                     const std::function<void()>& changed);
/// Fields for the behaviour shares and the seed of a recipe, in a column.
QWidget* makeMixFields(CrowdRecipe& recipe, const Theme& theme,
                       const std::function<void()>& changed, QWidget* parent);
/// Adds a combo box with these texts; `at` is the current index.
ChoiceField* addChoice(OptionsRow& row, const QString& label, const QStringList& words, int at,
                       const std::function<void(int)>& chosen);
/// Adds a narrow number field for a tool setting.
NumberField* addNumber(OptionsRow& row, const QString& label, const NumberField::Range& range,
                       const QString& unit, double value,
                       const std::function<void(double)>& changed);

}  // namespace editor
