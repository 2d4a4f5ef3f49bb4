#include <QDir>
#include <QFileInfo>

#include "app/run/RecordedRun.h"
#include "app/window/FileCommands.h"
#include "editor/document/DocumentSnapshot.h"

/// Recorded runs in the window.
namespace app {

void FileCommands::askOpenRun() {
  const QString path = dialogs_.openFolder(tr("Open the folder of a run"), folder());
  if (!path.isEmpty() && mayLeave()) {
    openFile(path);
  }
}

/// The document is the scenario of the run meanwhile, as far as it is known.
bool FileCommands::openRun(const QString& path) {
  const base::Result<RecordedRun> run = readRecordedRun(path.toStdString());
  if (!run) {
    return tell(run.diagnostics());
  }
  editor::ScenarioDocument& document = workspace_.document();
  if (!workspace_.runner().isRecorded()) {
    beforeRun_ = document.path();
  }
  scenarioOfRun_ = QString::fromStdString(run->scenario);
  document.clear();  // ends what was running
  document.setSearch({}, {});
  if (!scenarioOfRun_.isEmpty() && base::hasErrors(document.open(scenarioOfRun_))) {
    document.clear();
  }
  editor::DocumentSnapshot shown = document.snapshot();
  sim2d::Scenario scenario = scenarioOf(*run->recording, shown.scenario);
  const sim2d::OccupancyGrid& map = run->recording->header()->map;
  const bool isOtherMap = !(map == *shown.map.grid);
  if (isOtherMap || !(scenario == shown.scenario)) {
    shown.scenario = std::move(scenario);
    if (isOtherMap) {
      shown.map = {std::make_shared<const sim2d::OccupancyGrid>(map), {}, false, {}};
      shown.mapIsInFile = false;
    }
    document.restore(std::move(shown), true);
  }
  const QDir folder(path);  // with or without a slash at its end
  memory_.noteFile(folder.absolutePath());
  Q_EMIT recentChanged();
  Q_EMIT opened();  // first: the view fits what is drawn while nothing runs
  workspace_.openRecorded(run->recording, folder.dirName());
  return tell(run.diagnostics());
}

/// Back to what was there before, else to the scenario of the run.
void FileCommands::leaveRun() {
  const QString path = beforeRun_.isEmpty() ? scenarioOfRun_ : beforeRun_;
  if (path.isEmpty() || !QFileInfo::exists(path)) {
    workspace_.document().clear();
    Q_EMIT closed();
  } else {
    openScenario(path);
  }
}

}  // namespace app
