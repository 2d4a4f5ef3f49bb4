#include "editor/canvas/MapScene.h"
#include "editor/tools/CrowdOptions.h"
#include "editor/tools/CrowdTools.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

QString FillTool::idleText() const {
  return result_.isEmpty() ? tr("Drag or click the corners of the ground that %1 are to fill")
                                 .arg(peopleText(count_))
                           : result_;
}

QWidget* FillTool::makeOptions(QWidget* parent) {
  auto* row = new OptionsRow(parent);
  addNumber(*row, tr("People"), {1.0, double(kLargestCrowd), 0, 5.0}, {}, count_,
            [this](double value) {
              count_ = static_cast<int>(value);
              Q_EMIT statusTextChanged();
            });
  addRecipeFields(*row, recipe_, scene(), [this] { Q_EMIT statusTextChanged(); });
  return row;
}

void FillTool::preview(const Corners& corners) {
  showCrowd(scene(), fillCrowd(corners, count_, recipe_, document()));
  result_.clear();
}

void FillTool::make(const Corners& corners) {
  const std::vector<sim2d::Human> people = fillCrowd(corners, count_, recipe_, document());
  const int made = static_cast<int>(people.size());
  result_ = made == count_ ? QString()
                           : tr("There was room for %1 of %2").arg(made).arg(peopleText(count_));
  addCrowd(document(), people);
  Q_EMIT statusTextChanged();
}

void addFillTool(ToolRegistry& to) {
  to.add<FillTool>(
      {40, QObject::tr("Fill"), QStringLiteral("tool-fill"), Qt::Key_L, QStringLiteral("crowd")});
}

}  // namespace editor
