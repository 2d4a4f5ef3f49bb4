#include "app/window/runs/PlaybackSettings.h"

#include <QStringList>

namespace app {

using editor::SimulationRunner;

namespace {

constexpr const char* kTrails = "run/trailSeconds";
constexpr const char* kLoops = "run/loops";                    // rows: folder, A, B
constexpr double kShortestTrail = 1.0, kLongestTrail = 600.0;  // [s]

QString rowOf(const QString& folder, const SimulationRunner::LoopRange& part) {
  return QStringLiteral("%1\t%2\t%3")
      .arg(folder)
      .arg(part.from, 0, 'g', 17)
      .arg(part.to, 0, 'g', 17);
}

}  // namespace

PlaybackSettings::PlaybackSettings(Workspace& workspace, UserSettings& userSettings,
                                   QObject* parent)
    : QObject(parent), workspace_(workspace), userSettings_(userSettings) {
  editor::MapScene& scene = workspace_.scene();
  const double seconds = userSettings_.value(kTrails).toDouble();
  if (seconds >= kShortestTrail && seconds <= kLongestTrail) {
    editor::CanvasOptions options = scene.options();
    options.trailSeconds = seconds;
    scene.setOptions(options);
  }
  connect(&scene, &editor::MapScene::optionsChanged, this,
          [this] { userSettings_.setValue(kTrails, workspace_.scene().options().trailSeconds); });
  connect(&workspace_.runner(), &SimulationRunner::loopChanged, this, &PlaybackSettings::storeLoop);
}

void PlaybackSettings::restoreLoop(const QString& folder) {
  folder_ = folder;
  SimulationRunner& runner = workspace_.runner();
  const double end = runner.recording()->timeOf(runner.recording()->size() - 1);
  for (const QString& row : userSettings_.value(kLoops).toStringList()) {
    const QStringList parts = row.split(QLatin1Char('\t'));
    const SimulationRunner::LoopRange part{parts.value(1).toDouble(), parts.value(2).toDouble()};
    const bool isInside = part.from >= 0.0 && part.from < part.to && part.from < end;
    if (parts.size() == 3 && parts.front() == folder && isInside) {
      runner.setLoop(part);
      return;
    }
  }
}

/// Closing a run clears its loop; this is not stored as a change by the user.
void PlaybackSettings::storeLoop() {
  const SimulationRunner& runner = workspace_.runner();
  if (!workspace_.isRecordedRun() || runner.recording() == nullptr || folder_.isEmpty()) {
    return;
  }
  QStringList rows = userSettings_.value(kLoops).toStringList();
  for (int k = rows.size() - 1; k >= 0; --k) {
    if (rows[k].startsWith(folder_ + QLatin1Char('\t'))) {
      rows.removeAt(k);
    }
  }
  if (runner.loop()) {
    rows.prepend(rowOf(folder_, *runner.loop()));
  }
  userSettings_.setValue(kLoops, QStringList(rows.mid(0, kMostLoops)));
}

}  // namespace app
