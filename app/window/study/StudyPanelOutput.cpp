#include "app/run/DataPaths.h"
#include "app/run/RunSpec.h"
#include "app/window/study/StudyPanel.h"
#include "sim2d/nav/external/CommandLine.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

/// The run of a command line that opens it: "hunavsim FILE --seed 3 …".
base::Result<RunSpec> specOfCommand(const std::string& command) {
  base::Result<std::vector<std::string>> words = sim2d::splitCommandLine(command);
  if (!words) {
    return words.diagnostics();
  }
  words->front() = "run";
  return runSpecOfCommandLine(*words);
}

/// The folder in which a relative path is this file: the folder of the results or one that contains
/// it. Empty: none, or the path needs no folder.
QString folderOfRelative(const std::string& path, const QString& results) {
  const QString file = QString::fromStdString(path);
  if (QFileInfo(file).isAbsolute() || QFileInfo::exists(file)) {
    return {};
  }
  QDir folder(results);
  do {
    if (QFileInfo(folder.filePath(file)).isFile()) {
      return folder.absolutePath();
    }
  } while (folder.cdUp());
  return {};
}

bool isBadNews(const report::StudyOutput& results) {
  const auto* const gate = std::get_if<report::GateOutput>(&results);
  return gate != nullptr && gate->verdict == GateVerdict::Worse;
}

}  // namespace

bool StudyPanel::openOutput(const std::string& file) {
  base::Result<report::StudyOutput> results = report::readStudyOutput(file);
  if (!results) {
    showMessage(QString::fromStdString(results.diagnostics().front().text()), true);
    return false;
  }
  setFile({});
  isEdited_ = false;
  check_.stop();
  output_ = Output{QFileInfo(QString::fromStdString(file)).absolutePath(), *std::move(results)};
  formArea_->hide();
  showOutputPage();
  showSummary();
  updateControls();
  return true;
}

/// Also after a change of the theme: cells have fixed colours.
void StudyPanel::showOutputPage() {
  if (!output_) {
    return;
  }
  const int tab = page_ != nullptr ? page_->tabs().currentIndex() : 0;
  delete page_;
  page_ = makeOutputPage(output_->results, {output_->folder.toStdString(), context_.theme()});
  content_->addWidget(page_);
  content_->setCurrentWidget(page_);
  page_->tabs().setCurrentIndex(tab);
  connect(page_, &OutputPage::playRequested, this, &StudyPanel::playOutput);
}

void StudyPanel::closeOutput() {
  output_.reset();
  delete page_;
  page_ = nullptr;
  formArea_->show();
}

/// The headline of the shown results, or the progress of the experiment.
void StudyPanel::showSummary() {
  if (output_) {
    showMessage(outputHeadline(output_->results), isBadNews(output_->results));
  } else {
    showProgress();
  }
}

void StudyPanel::playOutput(const OutputRun& run) {
  if (helperProcess_.state() != QProcess::NotRunning) {
    return;  // it writes to the folder of the last run
  }
  base::Result<RunSpec> spec = specOfCommand(run.command);
  if (!spec) {
    showMessage(QString::fromStdString(spec.diagnostics().front().text()), true);
    return;
  }
  const QString folder = folderOfRelative(spec->scenario, output_ ? output_->folder : QString());
  if (!folder.isEmpty()) {
    spec->scenario = QDir(folder).filePath(QString::fromStdString(spec->scenario)).toStdString();
  }
  sim2d::Scenario scenario = sim2d::readScenario(scenarioFile(spec->scenario)).scenario;
  applyOptions(scenario, *spec, {});  // errors are reported by the run
  const std::vector<ExternalCode> code = externalCodeOf(scenario);
  if (!isCodeAllowed(code, [this, run] { playOutput(run); })) {
    return;
  }
  spec->allowCode = !code.empty();
  QStringList words;
  for (const std::string& word : commandLineOf(*spec)) {
    words.append(QString::fromStdString(word));
  }
  played_ = std::make_unique<QTemporaryDir>();
  const QString to = played_->filePath(QStringLiteral("run"));
  words << QStringLiteral("--quiet") << QStringLiteral("-o") << to;
  runProgram(
      words, tr("Replaying %1…").arg(run.title), [this, to] { Q_EMIT openRunRequested(to, true); },
      folder);
}

}  // namespace app
