#include "app/window/files/FileCommands.h"

#include "app/run/PlannerFiles.h"
#include "app/run/RecordedRun.h"
#include "app/run/RunReplay.h"
#include "app/window/WindowActions.h"
#include "app/window/files/MapFiles.h"
#include "app/window/settings/Preferences.h"
#include "app/window/study/StudyProcess.h"
#include "bt/tree/TreeXml.h"
#include "editor/canvas/Layers.h"
#include "editor/document/Autosave.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/look/DeferredActions.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackImport.h"

namespace app {

FileCommands::FileCommands(Workspace& workspace, editor::IssuesPanel& issues,
                           UserSettings& userSettings, QWidget& window)
    : QObject(&window),
      workspace_(workspace),
      issues_(issues),
      userSettings_(userSettings),
      window_(window) {
  connect(&workspace_.document(), &editor::ScenarioDocument::mapChanged, this, [this] {
    if (isMapRejected_) {
      showProblems({});
    }
  });
  connect(&workspace_, &Workspace::recordedRunClosed, this, &FileCommands::closeRun);
  connect(&workspace_.runner(), &editor::SimulationRunner::stateChanged, &issues_,
          [this] { issues_.setRecorded(workspace_.isRecordedRun()); });
}

void FileCommands::connectActions(const WindowActions& actions) {
  connect(actions.newFromMap, &QAction::triggered, this, &FileCommands::askNewFromMap);
  connect(actions.newEmptyRoom, &QAction::triggered, this, &FileCommands::askNewEmptyRoom);
  connect(actions.newOpenPlane, &QAction::triggered, this, [this] {
    if (maybeSave()) {
      newOpenPlane();
    }
  });
  connect(actions.open, &QAction::triggered, this, &FileCommands::askOpen);
  connect(actions.openRun, &QAction::triggered, this, &FileCommands::askOpenRun);
  connect(actions.openMap, &QAction::triggered, this, &FileCommands::askReplaceMap);
  connect(actions.importTracks, &QAction::triggered, this, &FileCommands::askImportTracks);
  connect(actions.save, &QAction::triggered, this, &FileCommands::save);
  connect(actions.saveAs, &QAction::triggered, this, &FileCommands::saveAs);
  connect(actions.exportTo, &QAction::triggered, this, &FileCommands::askExport);
  connect(actions.close, &QAction::triggered, this, [this] {
    if (maybeSave()) {
      close();
    }
  });
}

bool FileCommands::showProblems(const base::Diagnostics& problems) {
  isMapRejected_ = false;
  problems_ = problems;
  issues_.setActionIssues(problems);
  const bool fine = !base::hasErrors(problems);
  if (!fine) {
    Q_EMIT issuesRaised();
  }
  return fine;
}

bool FileCommands::openFile(const QString& path) {
  switch (kindOf(path)) {
    case Kind::Map:
      return openNewFromMap(path);
    case Kind::Image:
      return openNewFromImage(path);
    case Kind::Tree:
      return assignTree(path, {});
    case Kind::Run:
      return openRun(QFileInfo(path).isDir() ? path : QFileInfo(path).absolutePath());
    case Kind::Tracks:
      return openTracks(path);
    case Kind::Capsule:
      return openCapsule(path);
    case Kind::StudyResults:
      return openStudyResults(path);
    case Kind::Batch:
      return openExperiment(experimentOfBatch(path), path);
    case Kind::Experiment:
      return openExperiment(path, path);
    case Kind::Nav2:
      return showProblems({base::error("document.nav2-file", {}, path.toStdString())});
    case Kind::Scenario:
      break;
  }
  return openScenario(path);
}

bool FileCommands::dropFile(const QString& path, editor::EntityId under) {
  if (kindOf(path) == Kind::Tree) {
    return assignTree(path, under);
  }
  return mayOpen(path) && openFile(path);
}

bool FileCommands::openScenario(const QString& path, bool isTemporary) {
  editor::ScenarioDocument& document = workspace_.document();
  // Options given with a file apply only to that file, others to all files.
  const bool isMeant = options_.scenario.empty() || options_.scenario == path.toStdString();
  document.setSearchOverrides(isMeant ? QString::fromStdString(options_.map) : QString(),
                              isMeant ? QString::fromStdString(options_.trees) : QString());
  base::Diagnostics problems = document.open(path);
  const bool isShown = document.path() == QFileInfo(path).absoluteFilePath() &&
                       (!base::hasErrors(problems) || document.isReadOnly() ||
                        (!options_.map.empty() && document.mapState().isMissing));
  if (!base::hasErrors(problems) && isMeant) {
    base::append(problems, applyRunOptions());
  }
  if (isShown) {
    if (!isTemporary) {
      userSettings_.addRecentFile(path);
      Q_EMIT recentChanged();
    }
    Q_EMIT opened();
  }
  const bool isFine = showProblems(problems);
  if (isShown) {
    issues_.setActionIssues({});  // the panel shows the document's problems
  }
  return isFine;
}

bool FileCommands::restore(const QString& folder) {
  if (!maybeSave()) {
    return false;
  }
  base::Result<editor::DocumentSnapshot> copy = editor::readSnapshot(folder);
  if (!showProblems(copy.diagnostics()) || !copy) {
    return false;
  }
  workspace_.document().restore(*std::move(copy));
  Q_EMIT opened();
  return true;
}

/// Assigns the tree to the person it was dropped on, otherwise to the selected people, otherwise to
/// the person in the file name.
bool FileCommands::assignTree(const QString& path, editor::EntityId under) {
  editor::ScenarioDocument& document = workspace_.document();
  const base::Result<std::string> text = base::readTextFile(path.toStdString());
  base::Diagnostics problems = text.diagnostics();
  if (text) {
    base::append(problems, bt::readTreeText(*text, path.toStdString()).diagnostics());
  }
  std::vector<editor::EntityId> people;
  const auto addPerson = [&](editor::EntityId id) {
    if (document.human(id) != nullptr) {
      people.push_back(id);
    }
  };
  addPerson(under);
  if (people.empty()) {
    std::for_each(document.selection().begin(), document.selection().end(), addPerson);
  }
  static const QRegularExpression kName(QStringLiteral("__agent_(\\d+)_bt\\.xml$"));
  const QRegularExpressionMatch match = kName.match(path);
  if (people.empty() && match.hasMatch()) {
    if (const sim2d::Human* human = document.scenario().humanById(match.captured(1).toInt())) {
      addPerson(human->key);
    }
  }
  if (people.empty()) {
    problems.push_back(base::error("document.nobody-for-tree", {}, path.toStdString()));
  }
  if (!showProblems(problems)) {
    return false;
  }
  std::vector<editor::TreeEdit> edits;
  edits.reserve(people.size());
  for (const editor::EntityId id : people) {
    edits.push_back({id, *text});
  }
  editor::pushTrees(document, std::move(edits), tr("Assign tree"));
  return true;
}

base::Diagnostics FileCommands::applyRunOptions() {
  editor::ScenarioDocument& document = workspace_.document();
  sim2d::Scenario wanted = document.scenario();
  base::Diagnostics problems = applyOptions(wanted, options_, compatibility_);
  if (base::hasErrors(problems) || wanted == document.scenario()) {
    return problems;
  }
  std::vector<editor::Entity> values, newRobots;
  sim2d::forEachList(wanted, [&](base::EntityKind /*kind*/, const auto& list) {
    for (const auto& entity : list) {
      (document.contains(entity.key) ? values : newRobots).emplace_back(entity);
    }
  });
  values.emplace_back(static_cast<const sim2d::ScenarioSettings&>(wanted));
  QUndoStack& stack = document.undoStack();
  stack.beginMacro(tr("Apply command-line options"));
  editor::pushEdit(document, std::move(values), tr("Apply command-line options"));
  if (!newRobots.empty()) {
    editor::pushAdd(document, std::move(newRobots), tr("Add command-line robot"));
  }
  stack.endMacro();
  stack.setClean();  // the options are no change of the user
  Q_EMIT optionsApplied();
  return problems;
}

QString FileCommands::folder() const {
  const QString own = workspace_.document().path();
  QString preferred = userSettings_.value(kFolderKey).toString();
  if (own.isEmpty() && !preferred.isEmpty() && QFileInfo(preferred).isDir()) {
    return preferred;
  }
  QStringList files = userSettings_.recentFiles();
  files.prepend(own);
  for (const QString& file : files) {
    QString folder = QFileInfo(file).absolutePath();
    if (!file.isEmpty() && !workspace_.document().isShipped(file) && QFileInfo(folder).isDir()) {
      return folder;
    }
  }
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

QString FileCommands::askMapFile(const QString& title) {
  QFileDialog dialog(&window_, title, folder(),
                     tr("Maps, map images (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg)"));
  dialog.setFileMode(QFileDialog::ExistingFile);
  dialog.setOption(QFileDialog::DontUseNativeDialog);  // Native dialogs cannot hide scenarios.
  dialog.setProxyModel(new MapFileFilter(&dialog));
  return askFile(dialog, userSettings_);
}

QString FileCommands::ask(QFileDialog::FileMode mode, const QString& title, const QString& filter) {
  QFileDialog dialog(&window_, title, folder(), filter);
  dialog.setFileMode(mode);
  return askFile(dialog, userSettings_);
}

void FileCommands::askOpen() {
  openIfWanted(
      ask(QFileDialog::ExistingFile, tr("Open a scenario or a map"),
          tr("Scenarios, maps, map images, packed studies (*.yaml *.yml *.png *.pgm *.bmp *.jpg "
             "*.jpeg *.hnv)")));
}

void FileCommands::fillRecentMenu(QMenu& menu) {
  editor::clearLater(menu);
  for (const QString& path : userSettings_.recentFiles()) {
    QAction* action = menu.addAction(QFileInfo(path).fileName());
    action->setStatusTip(path);
    action->setToolTip(path);
    action->setEnabled(QFileInfo::exists(path));
    connect(action, &QAction::triggered, this, [this, path] { openIfWanted(path); });
  }
  menu.setEnabled(!menu.isEmpty());
}

bool FileCommands::openNewFromMap(const QString& mapYaml) {
  if (!showProblems(workspace_.document().newOnMap(mapYaml))) {
    return false;
  }
  Q_EMIT opened();
  return true;
}

void FileCommands::newOpenPlane() {
  workspace_.document().clear();
  showProblems({});
  Q_EMIT opened();
}

void FileCommands::close() {
  workspace_.document().clear();
  Q_EMIT closed();
}

void FileCommands::newOnMap(std::shared_ptr<const sim2d::OccupancyGrid> map) {
  workspace_.document().load(sim2d::Scenario());
  workspace_.document().setMap(std::move(map));
  showProblems({});
  Q_EMIT opened();
}

void FileCommands::askNewEmptyRoom() {
  RoomDialog dialog(workspace_.theme(), &window_);
  if (dialog.exec() == QDialog::Accepted && maybeSave()) {
    const QSizeF size = dialog.size();
    dialog.hasWalls() ? newOnMap(editor::emptyRoom(size.width(), size.height())) : newOpenPlane();
  }
}

void FileCommands::askNewFromMap() {
  const QString path = askMapFile(tr("New scenario from a map"));
  if (path.isEmpty() || !maybeSave()) {
    return;
  }
  kindOf(path) == Kind::Image ? openNewFromImage(path) : openNewFromMap(path);
}

/// Resolution and origin are those of the YAML file that names the image; without such a file they
/// are asked for.
bool FileCommands::openNewFromImage(const QString& path) {
  const QString yaml = mapYamlOf(path);
  if (!yaml.isEmpty()) {
    return openNewFromMap(yaml);
  }
  if (GridPtr map = askScaleOf(path)) {
    newOnMap(std::move(map));
  }
  return !base::hasErrors(problems_);
}

FileCommands::GridPtr FileCommands::askScaleOf(const QString& path) {
  constexpr double kResolution = 0.05;
  const base::Result<GridPtr> grid = editor::gridOfImage(path, kResolution);
  if (!showProblems(grid.diagnostics()) || !grid) {
    return nullptr;
  }
  QImage image(path);
  if (image.isNull()) {  // a format that only the map reader supports
    image = editor::mapImage(**grid, workspace_.theme());
  }
  ImageMapDialog dialog(*grid, image, workspace_.theme(), &window_);
  return dialog.exec() == QDialog::Accepted ? dialog.map() : nullptr;
}

void FileCommands::askReplaceMap() {
  const QString path = askMapFile(tr("Change map"));
  if (path.isEmpty()) {
    return;
  }
  const bool isImage = kindOf(path) == Kind::Image;
  const QString yaml = isImage ? mapYamlOf(path) : path;
  if (!yaml.isEmpty()) {
    replaceMap(yaml);
  } else if (GridPtr map = askScaleOf(path)) {
    editor::pushNewMap(workspace_.document(), std::move(map));
    workspace_.runner().reset();
  }
}

/// A map that cannot be read changes nothing, including a run.
bool FileCommands::replaceMap(const QString& path) {
  const bool isFine = showProblems(workspace_.document().openMap(path));
  if (isFine) {
    workspace_.runner().reset();
  }
  isMapRejected_ = !isFine;
  return isFine;
}

void FileCommands::askOpenRun() {
  openIfWanted(ask(QFileDialog::Directory, tr("Open run folder")));
}

/// A request that repeats the run. Empty: unknown origin, or external programs took part.
std::function<editor::RunRequest()> FileCommands::replayRequestOf(const QString& folder) const {
  const base::Result<RunProvenance> made = provenanceOf(folder.toStdString(), editor::loadMapImage);
  if (!made || !externalCodeOf(*made->bundle.scenario).empty()) {
    return {};
  }
  return [made = *made] { return editor::requestFor(made.bundle, made.branches); };
}

bool FileCommands::openRun(const QString& path, bool isTemporary) {
  const base::Result<RecordedRun> run = readRecordedRun(
      path.toStdString(), workspace_.runner().historyMemory(), IncompleteRecordings::Shown);
  if (!run) {
    return showProblems(run.diagnostics());
  }
  truncationOfRun_.reset();
  for (const base::Diagnostic& each : run.diagnostics()) {
    truncationOfRun_ = run->cut && (each.code == "trace.cut" || each.code == "trace.killed")
                           ? std::optional(each)
                           : truncationOfRun_;
  }
  base::Diagnostics remarks = run.diagnostics();
  base::append(remarks, otherProgramWarning(path.toStdString()));
  const QString name = QDir(path).dirName();
  if (!isTemporary) {
    remember(path);
  }
  showRun(*run, path, run->cut ? tr("%1 (truncated)").arg(name) : name,
          run->cut ? std::function<editor::RunRequest()>() : replayRequestOf(path));
  return showProblems(remarks);
}

void FileCommands::askImportTracks() {
  const QString path =
      ask(QFileDialog::ExistingFile, tr("Import trajectories"),
          tr("Trajectories (*.csv *.txt *.tsv *.h5 *.hdf5 *.sqlite *.ndjson *.json);;All files "
             "(*)"));
  if (!path.isEmpty() && maybeSave()) {
    openTracks(path);
  }
}

/// Third-party trajectories are shown as a recorded run.
bool FileCommands::openTracks(const QString& path) {
  const base::Result<sim2d::TrackFile> file = sim2d::importTracks(path.toStdString(), {});
  base::Diagnostics problems = file.diagnostics();
  if (!file) {
    return showProblems(problems);
  }
  base::Result<sim2d::Trace> trace = sim2d::traceOfTracks(*file, {});
  base::append(problems, trace.diagnostics());
  if (!trace) {
    return showProblems(problems);
  }
  RecordedRun run;
  run.recording = sim2d::recordingOf(*std::move(trace), workspace_.runner().historyMemory());
  truncationOfRun_.reset();
  remember(path);
  showRun(run, path, QFileInfo(path).fileName(), {});
  return showProblems(problems);
}

/// While a run is displayed, the document is its scenario, as far as known.
void FileCommands::showRun(const RecordedRun& run, const QString& path, const QString& name,
                           std::function<editor::RunRequest()> again) {
  editor::ScenarioDocument& document = workspace_.document();
  if (!workspace_.isRecordedRun()) {
    previousDocument_ = document.path();
  }
  scenarioOfRun_ = QString::fromStdString(run.scenario);
  document.clear();  // stops the current run
  document.setSearchOverrides({}, {});
  if (!scenarioOfRun_.isEmpty() && base::hasErrors(document.open(scenarioOfRun_))) {
    document.clear();
  }
  editor::DocumentSnapshot shown = document.snapshot();
  sim2d::Scenario scenario = scenarioOf(*run.recording, shown.scenario);
  const sim2d::OccupancyGrid& map = run.recording->header()->map;
  const bool isOtherMap = !(map == *shown.map.grid);
  if (isOtherMap || !(scenario == shown.scenario)) {
    shown.scenario = std::move(scenario);
    if (isOtherMap) {
      shown.map = {std::make_shared<const sim2d::OccupancyGrid>(map), {}, false, {}};
      shown.mapIsInFile = false;
    }
    document.restore(std::move(shown), true);
  }
  Q_EMIT opened();  // before the run, so that the view fits the scenario
  workspace_.openRecorded(run.recording, name, std::move(again));
  Q_EMIT runOpened(QDir(path).absolutePath());
}

/// Returns to the previous document, otherwise to the scenario of the run.
void FileCommands::closeRun() {
  const QString path = previousDocument_.isEmpty() ? scenarioOfRun_ : previousDocument_;
  if (path.isEmpty() || !QFileInfo::exists(path)) {
    close();
  } else {
    openScenario(path);
  }
}

}  // namespace app
