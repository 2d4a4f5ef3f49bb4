#pragma once

#include <functional>

#include <QHBoxLayout>
#include <QWidget>

#include "editor/canvas/MapScene.h"
#include "editor/look/Fields.h"
#include "editor/tools/Crowd.h"

namespace editor {

/// Fields of a tool in one row, with words before them.
class OptionsRow : public QWidget {
 public:
  explicit OptionsRow(QWidget* parent);
  void add(const QString& label, QWidget* field);

 private:
  QHBoxLayout* layout_;
};

/// Fields for a recipe, which has to outlive them; `changed` is called after each change.
void addRecipeFields(OptionsRow& row, CrowdRecipe& recipe, const MapScene& scene,
                     const std::function<void()>& changed);
/// Fields for the shares of the behaviours and the seed of a recipe, one below the other.
QWidget* makeMixFields(CrowdRecipe& recipe, const Theme& theme,
                       const std::function<void()>& changed, QWidget* parent);
/// A choice among words, of which number `at` is the present one.
ChoiceField* addChoice(OptionsRow& row, const QString& label, const QStringList& words, int at,
                       const std::function<void(int)>& chosen);
/// A narrow field for a number that a tool keeps.
NumberField* addNumber(OptionsRow& row, const QString& label, const NumberField::Range& range,
                       const QString& unit, double value,
                       const std::function<void(double)>& changed);

}  // namespace editor
