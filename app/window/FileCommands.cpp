#include "app/window/FileCommands.h"

#include <algorithm>

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>

#include "app/cli/RunWords.h"
#include "app/run/PlannerFiles.h"
#include "app/run/RecordedRun.h"
#include "app/run/RunMaking.h"
#include "app/window/MapDialogs.h"
#include "bt/tree/TreeXml.h"
#include "editor/canvas/Layers.h"
#include "editor/document/Autosave.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/document/QtImageLoader.h"
#include "editor/look/ClearLater.h"
#include "sim2d/base/Text.h"

namespace app {

FileCommands::FileCommands(Workspace& workspace, editor::IssuesPanel& issues, Memory& memory,
                           QWidget& window)
    : QObject(&window), workspace_(workspace), issues_(issues), memory_(memory), window_(window) {
  connect(&workspace_.document(), &editor::ScenarioDocument::mapChanged, this, [this] {
    if (mapRefused_) {
      tell({});
    }
  });
  connect(&workspace_, &Workspace::recordedRunLeft, this, &FileCommands::leaveRun);
}

bool FileCommands::tell(const base::Diagnostics& problems) {
  mapRefused_ = false;
  problems_ = problems;
  issues_.setActionIssues(problems);
  const bool fine = !base::hasErrors(problems);
  if (!fine) {
    Q_EMIT issuesRaised();
  }
  return fine;
}

bool FileCommands::isImage(const QString& path) {
  static const QStringList kImages = {QStringLiteral("png"), QStringLiteral("pgm"),
                                      QStringLiteral("bmp"), QStringLiteral("jpg"),
                                      QStringLiteral("jpeg")};
  return kImages.contains(QFileInfo(path).suffix().toLower());
}

/// By what stands in the file, for images by the name.
FileCommands::Kind FileCommands::kindOf(const QString& path) const {
  if (QFileInfo(path).isDir()) {
    return Kind::Run;
  }
  if (isImage(path)) {
    return Kind::Image;
  }
  const base::Result<std::string> text = base::readTextFile(path.toStdString());
  if (!text) {
    return Kind::Scenario;  // whose reader says what is wrong
  }
  const std::size_t first = text->find_first_not_of("\xEF\xBB\xBF \t\r\n");
  if (first != std::string::npos && (*text)[first] == '<') {
    return Kind::Tree;
  }
  const bool isScenario = text->find("ros__parameters") != std::string::npos;
  return !isScenario && text->find("image:") != std::string::npos ? Kind::Map : Kind::Scenario;
}

bool FileCommands::openFile(const QString& path) {
  switch (kindOf(path)) {
    case Kind::Map:
      return openNewFromMap(path);
    case Kind::Image:
      askMapOfImage(path);
      return true;
    case Kind::Tree:
      return giveTree(path, {});
    case Kind::Run:
      return openRun(path);
    case Kind::Scenario:
      break;
  }
  return openScenario(path);
}

bool FileCommands::dropFile(const QString& path, editor::EntityId under) {
  if (kindOf(path) == Kind::Tree) {
    return giveTree(path, under);
  }
  return mayLeave() && openFile(path);
}

bool FileCommands::openScenario(const QString& path) {
  editor::ScenarioDocument& document = workspace_.document();
  // options beside a file are meant for that file, others for all
  const bool isMeant = options_.scenario.empty() || options_.scenario == path.toStdString();
  document.setSearch(isMeant ? QString::fromStdString(options_.map) : QString(),
                     isMeant ? QString::fromStdString(options_.trees) : QString());
  base::Diagnostics problems = document.open(path);
  const bool isShown = document.path() == QFileInfo(path).absoluteFilePath() &&
                       (!base::hasErrors(problems) || document.isReadOnly() ||
                        (!options_.map.empty() && document.mapState().isMissing));
  if (!base::hasErrors(problems) && isMeant) {
    base::append(problems, applyRunOptions());
  }
  if (isShown) {
    memory_.noteFile(path);
    Q_EMIT recentChanged();
    Q_EMIT opened();
  }
  const bool isFine = tell(problems);
  if (isShown) {
    issues_.setActionIssues({});  // what the document keeps is shown by the panel anyway
  }
  return isFine;
}

bool FileCommands::restore(const QString& folder) {
  if (!mayLeave()) {
    return false;
  }
  base::Result<editor::DocumentSnapshot> copy = editor::readSnapshot(folder);
  if (!tell(copy.diagnostics()) || !copy) {
    return false;
  }
  workspace_.document().restore(*std::move(copy));
  Q_EMIT opened();
  return true;
}

/// To the person it fell on, else to those who are selected, else to the one its name speaks of.
bool FileCommands::giveTree(const QString& path, editor::EntityId under) {
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
  if (!tell(problems)) {
    return false;
  }
  std::vector<editor::TreeEdit> edits;
  edits.reserve(people.size());
  for (const editor::EntityId id : people) {
    edits.push_back({id, *text});
  }
  editor::pushTrees(document, std::move(edits), tr("Give a tree"));
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
  editor::pushEdit(document, std::move(values), tr("Options of the command line"));
  if (!newRobots.empty()) {
    editor::pushAdd(document, std::move(newRobots), tr("Robot of the command line"));
  }
  return problems;
}

QString FileCommands::folder() const {
  QStringList files = memory_.recentFiles();
  files.prepend(workspace_.document().path());
  for (const QString& file : files) {
    if (!file.isEmpty() && !workspace_.document().isShipped(file)) {
      return QFileInfo(file).absolutePath();
    }
  }
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

QString FileCommands::ask(QFileDialog::FileMode mode, const QString& title, const QString& filter) {
  QFileDialog dialog(&window_, title, folder(), filter);
  dialog.setFileMode(mode);
  return askFile(dialog, memory_);
}

void FileCommands::openIfWanted(const QString& path) {
  if (!path.isEmpty() && mayLeave()) {
    openFile(path);
  }
}

void FileCommands::askOpen() {
  openIfWanted(
      ask(QFileDialog::ExistingFile, tr("Open a scenario or a map"),
          tr("Scenarios, maps, images of maps (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg)")));
}

void FileCommands::fillRecentMenu(QMenu& menu) {
  editor::clearLater(menu);
  for (const QString& path : memory_.recentFiles()) {
    QAction* action = menu.addAction(QFileInfo(path).fileName());
    action->setStatusTip(path);
    action->setToolTip(path);
    action->setEnabled(QFileInfo::exists(path));
    connect(action, &QAction::triggered, this, [this, path] { openIfWanted(path); });
  }
  menu.setEnabled(!menu.isEmpty());
}

bool FileCommands::openNewFromMap(const QString& mapYaml) {
  if (!tell(workspace_.document().newOnMap(mapYaml))) {
    return false;
  }
  Q_EMIT opened();
  return true;
}

void FileCommands::newRoom() {
  workspace_.document().clear();
  tell({});
  Q_EMIT opened();
}

void FileCommands::newOnMap(std::shared_ptr<const sim2d::OccupancyGrid> map) {
  workspace_.document().load(sim2d::Scenario());
  workspace_.document().setMap(std::move(map));
  tell({});
  Q_EMIT opened();
}

void FileCommands::askNewRoom() {
  RoomDialog dialog(workspace_.theme(), &window_);
  if (dialog.exec() == QDialog::Accepted && mayLeave()) {
    const QSizeF size = dialog.size();
    dialog.hasWalls() ? newOnMap(editor::emptyRoom(size.width(), size.height())) : newRoom();
  }
}

void FileCommands::askNewFromMap() {
  const QString path = ask(QFileDialog::ExistingFile, tr("New scenario on a map"),
                           tr("Maps and images (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg)"));
  if (path.isEmpty()) {
    return;
  }
  if (kindOf(path) == Kind::Image) {
    askMapOfImage(path);
  } else if (mayLeave()) {
    openNewFromMap(path);
  }
}

void FileCommands::askMapOfImage(const QString& path) {
  constexpr double kResolution = 0.05;
  const base::Result<std::shared_ptr<const sim2d::OccupancyGrid>> grid =
      editor::gridOfImage(path, kResolution);
  if (!tell(grid.diagnostics()) || !grid) {
    return;
  }
  QImage image(path);
  if (image.isNull()) {  // a format that only the map reader knows
    image = editor::mapImage(**grid, workspace_.theme());
  }
  ImageMapDialog dialog(*grid, image, workspace_.theme(), &window_);
  if (dialog.exec() == QDialog::Accepted && mayLeave()) {
    newOnMap(dialog.map());
  }
}

void FileCommands::askOtherMap() {
  const QString path =
      ask(QFileDialog::ExistingFile, tr("Put a map under the scenario"), tr("Maps (*.yaml *.yml)"));
  if (!path.isEmpty()) {
    putOtherMap(path);
  }
}

/// One that cannot be read leaves everything as it is, a run too.
bool FileCommands::putOtherMap(const QString& path) {
  const bool isFine = tell(workspace_.document().openMap(path));
  if (isFine) {
    workspace_.runner().reset();
  }
  mapRefused_ = !isFine;
  return isFine;
}

void FileCommands::askOpenRun() {
  openIfWanted(ask(QFileDialog::Directory, tr("Open the folder of a run")));
}

/// The same run, made here; null: that is not known, or others' programs took part.
std::function<editor::RunRequest()> FileCommands::againOf(const QString& folder) const {
  const base::Result<RunMaking> making =
      makingOf(folder.toStdString(), readRunWords, editor::loadMapImage);
  if (!making || !foreignCodeOf(*making->bundle.scenario).empty()) {
    return {};
  }
  return [making = *making] { return editor::requestOf(making.bundle, making.stages); };
}

/// The document is the scenario of the run meanwhile, as far as it is known.
bool FileCommands::openRun(const QString& path) {
  const base::Result<RecordedRun> run =
      readRecordedRun(path.toStdString(), workspace_.runner().historyMemory(), CutRecords::Shown);
  if (!run) {
    return tell(run.diagnostics());
  }
  editor::ScenarioDocument& document = workspace_.document();
  if (!workspace_.isOfRecord()) {
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
  base::Diagnostics remarks = run.diagnostics();
  base::append(remarks, otherProgram(path.toStdString()));
  cutOfRun_.reset();
  for (const base::Diagnostic& each : run.diagnostics()) {
    cutOfRun_ = run->cut && (each.code == "trace.cut" || each.code == "trace.killed")
                    ? std::optional(each)
                    : cutOfRun_;
  }
  const QString name = folder.dirName();
  workspace_.openRecorded(run->recording, run->cut ? tr("%1 (cut)").arg(name) : name,
                          run->cut ? std::function<editor::RunRequest()>() : againOf(path));
  Q_EMIT runOpened(folder.absolutePath());
  return tell(remarks);
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
