#include "editor/tools/FillTool.h"

#include "editor/canvas/Layers.h"
#include "editor/canvas/MapScene.h"
#include "editor/document/EditCommands.h"
#include "editor/tools/CrowdOptions.h"
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
  std::vector<ToolDot> dots;
  for (const sim2d::Human& human : fillCrowd(corners, count_, recipe_, document())) {
    const Look look = lookOf(*human.behavior.type);
    dots.push_back({human.initPose.position, *human.radius, scene().theme().line(look),
                    human.initPose.heading});
  }
  scene().toolLayer().setDots(std::move(dots));
  result_.clear();
}

void FillTool::make(const Corners& corners) {
  std::vector<Entity> people;
  for (sim2d::Human& human : fillCrowd(corners, count_, recipe_, document())) {
    people.emplace_back(std::move(human));
  }
  const int made = static_cast<int>(people.size());
  result_ = made == count_ ? QString()
                           : tr("There was room for %1 of %2").arg(made).arg(peopleText(count_));
  if (made > 0) {
    document().setSelection(
        pushAdd(document(), std::move(people), tr("Add %1").arg(peopleText(made))));
  }
  Q_EMIT statusTextChanged();
}

void addFillTool(ToolRegistry& to) {
  to.add<FillTool>(
      {40, QObject::tr("Fill"), QStringLiteral("tool-fill"), Qt::Key_L, QStringLiteral("crowd")});
}

}  // namespace editor
