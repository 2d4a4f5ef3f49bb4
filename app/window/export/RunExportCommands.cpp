#include "app/window/export/RunExportCommands.h"

#include "app/window/RunCommands.h"

namespace app {

using editor::SimulationRunner;

namespace {

/// The state at the start of the scenario. The robots stand still, so that no external planner
/// starts.
base::Result<sim2d::Trace> startOf(Bundle bundle) {
  auto scenario = std::make_shared<sim2d::Scenario>(*bundle.scenario);
  for (sim2d::Robot& robot : scenario->robots) {
    robot.planner.reset();
    robot.command.reset();
    robot.plannerParameters.clear();
  }
  bundle.scenario = std::move(scenario);
  const Verdict verdict = check(bundle);
  if (verdict.world == nullptr) {
    return errorsOf(verdict.problems);
  }
  sim2d::Trace trace;
  trace.header = verdict.world->header();
  trace.frames.push_back(verdict.world->frame());
  return trace;
}

}  // namespace

RunExportCommands::RunExportCommands(Workspace& workspace, Docks& docks,
                                     const WindowActions& actions, UserSettings& userSettings,
                                     QWidget& window)
    : QObject(&window),
      workspace_(workspace),
      docks_(docks),
      actions_(actions),
      userSettings_(userSettings),
      window_(window) {
  connect(actions_.savePicture, &QAction::triggered, this, &RunExportCommands::savePicture);
  connect(actions_.saveFilm, &QAction::triggered, this, &RunExportCommands::saveFilm);
  connect(&workspace_.runner(), &SimulationRunner::stateChanged, this,
          &RunExportCommands::updateEnabled);
  updateEnabled();
}

void RunExportCommands::setOpen(bool isOpen) {
  isOpen_ = isOpen;
  updateEnabled();
}

void RunExportCommands::updateEnabled() {
  editor::setEnabled(*actions_.savePicture, isOpen_, tr("Open a scenario or a run first"));
  editor::setEnabled(*actions_.saveFilm, isOpen_ && workspace_.runner().recording() != nullptr,
                     tr("Start a run first: Space"));
}

ExportSource RunExportCommands::source() const {
  const SimulationRunner& runner = workspace_.runner();
  ExportSource source;
  source.name = workspace_.isRecordedRun()
                    ? workspace_.recordedName()
                    : QFileInfo(workspace_.document().displayName()).completeBaseName();
  source.options = figureOptionsOf(workspace_.scene());
  const editor::RecordingPtr recording = runner.recording();
  const editor::FramePtr shown = runner.shownFrame();
  if (recording == nullptr || recording->size() == 0 || shown == nullptr) {
    source.isRun = false;
    source.trace = [bundle = workspace_.document().bundle()] { return startOf(bundle); };
    return source;
  }
  source.hasForces = !runner.isRecorded();
  source.from = runner.oldestTime();
  source.to = recording->timeOf(recording->size() - 1);
  source.shown = shown->time;
  if (runner.loop()) {
    source.loop = std::pair(runner.loop()->from, std::min(runner.loop()->to, source.to));
  }
  source.trace = [recording] { return base::Result<sim2d::Trace>(recording->trace()); };
  return source;
}

AskExportFile RunExportCommands::askFile(const QString& title) {
  return [this, title](const QString& suggestion, const QString& ending) {
    QWidget* const above = QApplication::activeModalWidget();
    QFileDialog dialog(above != nullptr ? above : &window_, title, docks_.context().folder(),
                       QStringLiteral("%1 (*%2)").arg(ending.mid(1).toUpper(), ending));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(ending.mid(1));
    dialog.selectFile(suggestion);
    return app::askFile(dialog, userSettings_);
  };
}

void RunExportCommands::savePicture() {
  workspace_.runner().pause();
  SavePictureDialog dialog(source(), askFile(tr("Save picture")), workspace_.theme(), &window_);
  run(dialog);
}

void RunExportCommands::saveFilm() {
  workspace_.runner().pause();
  SaveFilmDialog dialog(source(), askFile(tr("Save film")), workspace_.theme(), &window_);
  run(dialog);
}

void RunExportCommands::run(RunExportDialog& dialog) {
  if (dialog.exec() == QDialog::Accepted) {
    Q_EMIT saved(dialog.savedFile());
  }
}

}  // namespace app
