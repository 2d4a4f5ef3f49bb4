#include "app/window/RunMemory.h"

#include <QStringList>

namespace app {

using editor::SimulationRunner;

namespace {

constexpr const char* kTrails = "run/trailSeconds";
constexpr const char* kLoops = "run/loops";                    // rows of folder, A and B
constexpr double kShortestTrail = 1.0, kLongestTrail = 600.0;  // [s]

QString rowOf(const QString& folder, const SimulationRunner::Part& part) {
  return QStringLiteral("%1\t%2\t%3")
      .arg(folder)
      .arg(part.from, 0, 'g', 17)
      .arg(part.to, 0, 'g', 17);
}

}  // namespace

RunMemory::RunMemory(Workspace& workspace, Memory& memory, QObject* parent)
    : QObject(parent), workspace_(workspace), memory_(memory) {
  editor::MapScene& scene = workspace_.scene();
  const double seconds = memory_.value(kTrails).toDouble();
  if (seconds >= kShortestTrail && seconds <= kLongestTrail) {
    editor::CanvasOptions options = scene.options();
    options.trailSeconds = seconds;
    scene.setOptions(options);
  }
  connect(&scene, &editor::MapScene::optionsChanged, this,
          [this] { memory_.setValue(kTrails, workspace_.scene().options().trailSeconds); });
  connect(&workspace_.runner(), &SimulationRunner::loopChanged, this, &RunMemory::noteLoop);
}

void RunMemory::followRun(const QString& folder) {
  folder_ = folder;
  SimulationRunner& runner = workspace_.runner();
  const double end = runner.recording()->timeOf(runner.recording()->size() - 1);
  for (const QString& row : memory_.value(kLoops).toStringList()) {
    const QStringList parts = row.split(QLatin1Char('\t'));
    const SimulationRunner::Part part{parts.value(1).toDouble(), parts.value(2).toDouble()};
    const bool isInside = part.from >= 0.0 && part.from < part.to && part.from < end;
    if (parts.size() == 3 && parts.front() == folder && isInside) {
      runner.setLoop(part);
      return;
    }
  }
}

/// A run that is left takes its loop away: that is no wish of the user.
void RunMemory::noteLoop() {
  const SimulationRunner& runner = workspace_.runner();
  if (!workspace_.isOfRecord() || runner.recording() == nullptr || folder_.isEmpty()) {
    return;
  }
  QStringList rows = memory_.value(kLoops).toStringList();
  for (int k = rows.size() - 1; k >= 0; --k) {
    if (rows[k].startsWith(folder_ + QLatin1Char('\t'))) {
      rows.removeAt(k);
    }
  }
  if (runner.loop()) {
    rows.prepend(rowOf(folder_, *runner.loop()));
  }
  memory_.setValue(kLoops, QStringList(rows.mid(0, kMostLoops)));
}

}  // namespace app
