#include <QtWidgets>

#include "app/capsule/Unpacked.h"
#include "app/report/StudyOutput.h"
#include "app/run/Experiment.h"
#include "app/window/files/FileCommands.h"
#include "app/window/study/StudyProcess.h"

namespace app {

void FileCommands::remember(const QString& run) {
  userSettings_.addRecentFile(QDir(run).absolutePath());  // with or without a trailing slash
  Q_EMIT recentChanged();
}

void FileCommands::openIfWanted(const QString& path) {
  if (!path.isEmpty() && mayOpen(path)) {
    openFile(path);
  }
}

bool FileCommands::mayOpen(const QString& path) {
  const Kind kind = kindOf(path);
  return kind == Kind::StudyResults || kind == Kind::Experiment || kind == Kind::Batch ||
         kind == Kind::Nav2 || maybeSave();
}

/// The results of a batch are put where the study panel looks for them: beside the experiment.
bool FileCommands::openCapsule(const QString& path) {
  auto folder = std::make_unique<QTemporaryDir>();
  const QString root = QFileInfo(folder->path()).canonicalFilePath() + QStringLiteral("/study");
  const base::Result<capsule::UnpackedStudy> study =
      capsule::unpackStudy(path.toStdString(), root.toStdString());
  if (!study) {
    return showProblems(study.diagnostics());
  }
  if (study->isBatch && isStudyRunning_()) {
    return refuseStudy(path);
  }
  const QFileInfo experiment(QString::fromStdString(study->experiment));
  const QString results = study->isBatch
                              ? experiment.absoluteDir().filePath(experiment.completeBaseName() +
                                                                  QStringLiteral("_results"))
                              : QDir(root).filePath(QFileInfo(path).completeBaseName());
  if (!QDir().rename(QString::fromStdString(study->folder), results)) {
    return showProblems(
        {base::error("file.cannot-write", {"its name is in use"}, results.toStdString())});
  }
  unpacked_.push_back(std::move(folder));
  remember(path);
  if (!study->isBatch) {
    return openRun(results, true);
  }
  const base::Result<Experiment> read = readExperiment(study->experiment);
  if (!read) {
    return showProblems(read.diagnostics());
  }
  const bool isOpened = openScenario(QString::fromStdString(read->scenarioPaths.front()), true);
  Q_EMIT studyOpened(experiment.absoluteFilePath());
  return isOpened;
}

/// Opens the experiment in `file` or the folder of its results, which is then `shown`. An open
/// document stays open; if there is none, the first scenario is opened.
bool FileCommands::openExperiment(const QString& file, const QString& shown) {
  if (file.isEmpty()) {
    return showProblems({missingExperimentOf(shown)});
  }
  if (isStudyRunning_()) {
    return refuseStudy(shown);
  }
  const base::Result<Experiment> experiment = readExperiment(file.toStdString());
  if (!experiment) {
    return showProblems(experiment.diagnostics());
  }
  const editor::ScenarioDocument& document = workspace_.document();
  if (document.path().isEmpty() && !document.isDirty()) {
    openScenario(QString::fromStdString(experiment->scenarioPaths.front()), true);
  }
  remember(shown);
  Q_EMIT studyOpened(shown);
  return true;
}

bool FileCommands::refuseStudy(const QString& path) {
  return showProblems({base::error("study.running", {}, path.toStdString())});
}

/// The document stays open.
bool FileCommands::openStudyResults(const QString& path) {
  if (isStudyRunning_()) {
    return refuseStudy(path);
  }
  const base::Result<report::StudyOutput> results =
      report::readStudyOutput(*report::studyOutputFile(path.toStdString()));
  if (!results) {
    return showProblems(results.diagnostics());
  }
  remember(path);
  Q_EMIT studyOpened(path);
  return true;
}

}  // namespace app
