#include "app/window/FileCommands.h"

#include <algorithm>

#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>

#include "bt/tree/TreeXml.h"
#include "editor/document/DocumentSnapshot.h"
#include "editor/document/EditCommands.h"
#include "sim2d/base/Text.h"

namespace app {

FileCommands::FileCommands(Workspace& workspace, editor::IssuesPanel& issues, Memory& memory,
                           QWidget& window)
    : QObject(&window),
      workspace_(workspace),
      issues_(issues),
      memory_(memory),
      window_(window),
      dialogs_(memory, window) {
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
      Q_EMIT imageWanted(path);
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

bool FileCommands::reload() {
  return openScenario(workspace_.document().path());
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
  document.undoStack().beginMacro(tr("Give a tree"));
  for (const editor::EntityId id : people) {
    document.undoStack().push(new editor::EditTree(document, id, *text, tr("Give a tree")));
  }
  document.undoStack().endMacro();
  return true;
}

base::Diagnostics FileCommands::applyRunOptions() {
  editor::ScenarioDocument& document = workspace_.document();
  sim2d::Scenario wanted = document.scenario();
  base::Diagnostics problems = applyOptions(wanted, options_, compatibility_);
  if (base::hasErrors(problems) || wanted == document.scenario()) {
    return problems;
  }
  std::vector<editor::Entity> values;
  values.insert(values.end(), wanted.humans.begin(), wanted.humans.end());
  values.insert(values.end(), wanted.goals.begin(), wanted.goals.end());
  values.insert(values.end(), wanted.obstacles.begin(), wanted.obstacles.end());
  values.insert(values.end(), wanted.doors.begin(), wanted.doors.end());
  values.insert(values.end(), wanted.areas.begin(), wanted.areas.end());
  values.emplace_back(editor::ScenarioSettings{wanted.yamlBaseName, wanted.simulator, wanted.map,
                                               wanted.publishPeople, wanted.desktop});
  std::vector<editor::Entity> newRobots;
  for (const sim2d::Robot& robot : wanted.robots) {
    (document.contains(robot.key) ? values : newRobots).emplace_back(robot);
  }
  editor::pushEdit(document, std::move(values), tr("Options of the command line"));
  if (!newRobots.empty()) {
    editor::pushAdd(document, std::move(newRobots), tr("Robot of the command line"));
  }
  return problems;
}

QString FileCommands::folder() const {
  const QString path = workspace_.document().path();
  if (!path.isEmpty()) {
    return QFileInfo(path).absolutePath();
  }
  const QStringList recent = memory_.recentFiles();
  return recent.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                          : QFileInfo(recent.front()).absolutePath();
}

void FileCommands::askOpen() {
  const QString path = dialogs_.openFile(
      tr("Open a scenario or a map"), folder(),
      tr("Scenarios, maps, images of maps (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg)"));
  if (!path.isEmpty() && mayLeave()) {
    openFile(path);
  }
}

void FileCommands::fillRecentMenu(QMenu& menu) {
  menu.clear();
  for (const QString& path : memory_.recentFiles()) {
    QAction* action = menu.addAction(QFileInfo(path).fileName());
    action->setStatusTip(path);
    action->setToolTip(path);
    action->setEnabled(QFileInfo::exists(path));
    connect(action, &QAction::triggered, this, [this, path] {
      if (mayLeave()) {
        openFile(path);
      }
    });
  }
  menu.setEnabled(!menu.isEmpty());
}

}  // namespace app
