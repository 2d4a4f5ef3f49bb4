#include "app/run/Batch.h"
#include "app/run/ExperimentRunner.h"
#include "app/run/RunSpec.h"
#include "app/window/study/StudyPanel.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

bool holds(const std::vector<ExternalCode>& all, const ExternalCode& code) {
  return std::find(all.begin(), all.end(), code) != all.end();
}

/// The external code that runs of the experiment would start, in all of its scenarios.
std::vector<ExternalCode> externalCodeOfStudy(const Experiment& experiment) {
  std::vector<ExternalCode> all;
  for (std::size_t k = 0; k < experiment.scenarioPaths.size(); ++k) {
    for (const ExternalCode& code : externalCodeOf(experiment, k)) {
      if (!holds(all, code)) {
        all.push_back(code);
      }
    }
  }
  return all;
}

}  // namespace

/// Checks the results folder before the file is written, because the file belongs to the existing
/// results.
bool StudyPanel::canUseFolder(StudyProcess::Begin begin) {
  const QString folder = resultsFolder();
  const QString busy = folderWriter(folder);
  QString problem = busy;
  if (problem.isEmpty() && begin == StudyProcess::Begin::Resume) {
    const base::Result<std::string> text =
        isEdited_ ? form_->yamlFor(QFileInfo(file_).absolutePath()).toStdString()
                  : base::readTextFile(file_.toStdString());
    problem = text ? resumeObstacle(folder, *text) : QString();  // otherwise `batch` reports it
  }
  if (!problem.isEmpty()) {
    showMessage(editor::capitalized(problem), true);
    restartButton_->setVisible(busy.isEmpty());
  }
  return problem.isEmpty();
}

/// If the code is not allowed, asks for it; `then` is called on consent.
bool StudyPanel::isCodeAllowed(const std::vector<ExternalCode>& code,
                               const std::function<void()>& then) {
  if (std::all_of(code.begin(), code.end(),
                  [this](const ExternalCode& each) { return holds(allowedCode_, each); })) {
    return true;
  }
  whenAllowed_ = then;
  showMessage(tr("Its runs start external programs: allow them above the map"));
  Q_EMIT codePermissionNeeded(code);
  return false;
}

void StudyPanel::allowCode(const std::vector<ExternalCode>& code) {
  allowedCode_.insert(allowedCode_.end(), code.begin(), code.end());
  if (const auto then = std::exchange(whenAllowed_, {})) {
    then();
  }
}

void StudyPanel::start(StudyProcess::Begin begin) {
  if (isRunning() || output_) {
    return;
  }
  if (hasUnsavedScenario() && !runsSavedFile_) {
    askToSave(begin);
    return;
  }
  base::Result<Experiment> checked = experiment();
  if (file_.isEmpty() && checked) {
    chooseFile();
    checked = experiment();
  }
  if (file_.isEmpty() || !checked) {
    check();
    return;
  }
  check_.stop();  // it would replace the message set here
  start_->setEnabled(true);
  hideAnswers();
  const std::vector<ExternalCode> code = externalCodeOfStudy(*checked);
  if (!canUseFolder(begin) || !isCodeAllowed(code, [this, begin] { start(begin); }) || !save()) {
    return;
  }
  runningExperiment_ = *checked;
  runningExperiment_->allowCode = !code.empty();
  runsSavedFile_ = false;
  process_.start(file_, resultsFolder(), processorCount(), begin, runningExperiment_->allowCode);
  showMessage(tr("Starting…"));
  updateControls();
}

/// Offers to save the open scenario before the study reads its file.
void StudyPanel::askToSave(StudyProcess::Begin begin) {
  check_.stop();  // it would replace the question
  begin_ = begin;
  showMessage(tr("%1 has unsaved changes.").arg(context_.document.displayName()), true);
  saveButton_->show();
  asSavedButton_->show();
}

void StudyPanel::startSaved() {
  const QString before = context_.document.path();
  Q_EMIT saveRequested();
  if (!context_.document.isDirty()) {  // otherwise the user cancelled
    form_->replaceScenario(before, context_.document.path());
    start(begin_);
  }
}

void StudyPanel::startAsSaved() {
  runsSavedFile_ = true;
  start(begin_);
}

void StudyPanel::stop() {
  process_.stop();
  showMessage(tr("Stopping…"));
}

void StudyPanel::showProgress() {
  const std::vector<StudyRow>& rows = results_->runs().rows();
  const std::size_t finished = rows.size();
  const std::size_t made = finished - std::min(before_, finished);
  QString text = tr("%1 of %2 runs").arg(finished).arg(total_);
  if (isRunning() && made > 0 && finished < total_) {
    const double seconds = 1e-3 * static_cast<double>(since_.elapsed());
    const double left =
        seconds / static_cast<double>(made) * static_cast<double>(total_ - finished);
    text += tr(", %1 left").arg(studyTimeText(left));
  }
  const auto failed =
      std::count_if(rows.begin(), rows.end(), [](const StudyRow& row) { return !row.isOk; });
  if (failed > 0) {
    text += tr(", %1 failed").arg(failed);
  }
  progress_->setValue(
      total_ == 0
          ? 0
          : static_cast<int>(static_cast<std::size_t>(progress_->maximum()) * finished / total_));
  showMessage(text);
  Q_EMIT context_.counted(this, static_cast<int>(finished));
}

void StudyPanel::finish(bool isComplete, const QString& problems) {
  results_->compare();
  if (!problems.isEmpty()) {
    const QStringList lines = problems.split(QLatin1Char('\n'));
    showMessage(withoutSeverity(lines.front()), true);
    messageLabel_->setToolTip(problems);  // all of them
    restartButton_->setVisible(QFileInfo::exists(resultsFolder()));
  } else {
    showProgress();
    if (!isComplete) {
      showMessage(messageLabel_->text() + tr(": stopped, finished runs are kept"));
    }
  }
  updateControls();
}

/// Runs one process at a time; requests while it is running are ignored.
void StudyPanel::runProgram(const QStringList& words, const QString& saying,
                            const std::function<void()>& then, const QString& workingFolder) {
  if (helperProcess_.state() != QProcess::NotRunning) {
    return;
  }
  showMessage(saying);
  helperProcess_.disconnect(this);
  connect(&helperProcess_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      showMessage(helperProcess_.errorString(), true);
    }
  });
  connect(&helperProcess_, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this,
          [this, then](int code, QProcess::ExitStatus status) {
            const bool isFine = status == QProcess::NormalExit && code <= 1;
            if (isFine) {
              showSummary();
              then();
            } else {
              showMessage(QString::fromUtf8(helperProcess_.readAllStandardError()).trimmed(), true);
            }
          });
  helperProcess_.setWorkingDirectory(workingFolder);
  helperProcess_.start(process_.program(), words);
}

/// Plays the kept folder of a run; otherwise the run is repeated first.
void StudyPanel::play(int run) {
  const QString kept = QDir(resultsFolder()).filePath(QStringLiteral("runs/%1").arg(run));
  if (QFileInfo::exists(kept)) {
    Q_EMIT openRunRequested(kept, false);
    return;
  }
  if (!displayedExperiment_ || static_cast<std::size_t>(run) >= displayedExperiment_->runCount()) {
    showMessage(tr("Run %1 was not recorded, and its experiment can no longer be read").arg(run),
                true);
    return;
  }
  const std::vector<ExternalCode> code = externalCodeOfStudy(*displayedExperiment_);
  if (!isCodeAllowed(code, [this, run] { play(run); })) {
    return;
  }
  displayedExperiment_->allowCode = !code.empty();
  QStringList words;
  for (const std::string& word :
       commandLineOf(displayedExperiment_->specOf(static_cast<std::size_t>(run)))) {
    words.append(QString::fromStdString(word));
  }
  played_ = std::make_unique<QTemporaryDir>();
  const QString folder = played_->filePath(QStringLiteral("run_%1").arg(run));
  words << QStringLiteral("--quiet") << QStringLiteral("-o") << folder;
  runProgram(words, tr("Replaying run %1…").arg(run),
             [this, folder] { Q_EMIT openRunRequested(folder, true); });
}

void StudyPanel::openReport() {
  if (output_) {
    const QString page = QString::fromStdString(report::studyOutputPage(output_->results));
    QDesktopServices::openUrl(QUrl::fromLocalFile(QDir(output_->folder).filePath(page)));
    return;
  }
  const QString folder = resultsFolder();
  runProgram({QStringLiteral("report"), folder, QStringLiteral("--quiet")},
             tr("Writing the report…"), [this, folder] {
               const QString page = QDir(folder).filePath(QStringLiteral("report.html"));
               showMessage(tr("Report written to %1").arg(QDir::toNativeSeparators(page)));
               QDesktopServices::openUrl(QUrl::fromLocalFile(page));
             });
}

}  // namespace app
