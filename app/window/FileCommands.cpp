#include "app/window/FileCommands.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QStandardPaths>

#include "editor/document/EditCommands.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr int kRecentFiles = 8;
constexpr const char* kRecentKey = "files/recent";

}  // namespace

Memory::Memory(bool remembers) {
  if (remembers) {
    store_ = std::make_unique<QSettings>(QStringLiteral("hunavsim"), QStringLiteral("desktop"));
  }
}

QVariant Memory::value(const char* key) const {
  return store_ ? store_->value(QString::fromLatin1(key)) : QVariant();
}

void Memory::setValue(const char* key, const QVariant& value) {
  if (store_) {
    store_->setValue(QString::fromLatin1(key), value);
  }
}

QStringList Memory::recentFiles() const {
  return value(kRecentKey).toStringList();
}

void Memory::noteFile(const QString& path) {
  QStringList files = recentFiles();
  const QString whole = QFileInfo(path).absoluteFilePath();
  files.removeAll(whole);
  files.prepend(whole);
  while (files.size() > kRecentFiles) {
    files.removeLast();
  }
  setValue(kRecentKey, files);
}

void Memory::clearRecent() {
  setValue(kRecentKey, QStringList());
}

FileCommands::FileCommands(Workspace& workspace, editor::IssuesPanel& issues, Memory& memory,
                           QWidget& window)
    : QObject(&window), workspace_(workspace), issues_(issues), memory_(memory), window_(window) {}

bool FileCommands::tell(const base::Diagnostics& problems) {
  problems_ = problems;
  issues_.setActionIssues(problems);
  const bool fine = !base::hasErrors(problems);
  if (!fine) {
    Q_EMIT issuesRaised();
  }
  return fine;
}

bool FileCommands::isMap(const QString& path) const {
  const base::Result<std::string> text = base::readTextFile(path.toStdString());
  if (!text) {
    return false;
  }
  for (const std::string& line : base::split(*text, '\n')) {
    if (line.rfind("image:", 0) == 0) {
      return true;
    }
  }
  return false;
}

bool FileCommands::openFile(const QString& path) {
  if (isMap(path)) {
    return openNewFromMap(path);
  }
  base::Diagnostics problems = workspace_.document().open(path);
  if (!base::hasErrors(problems)) {
    base::append(problems, applyRunOptions());
  }
  if (!tell(problems)) {
    return false;
  }
  // What the document keeps is shown by the panel anyway.
  issues_.setActionIssues({});
  memory_.noteFile(path);
  Q_EMIT recentChanged();
  Q_EMIT opened();
  return true;
}

base::Diagnostics FileCommands::applyRunOptions() {
  editor::ScenarioDocument& document = workspace_.document();
  sim2d::Scenario wanted = document.scenario();
  base::Diagnostics problems = applyOptions(wanted, options_, {});
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

bool FileCommands::openNewFromMap(const QString& mapYaml) {
  editor::ScenarioDocument& document = workspace_.document();
  document.clear();
  const base::Diagnostics problems = document.openMap(mapYaml);
  if (!tell(problems)) {
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

bool FileCommands::saveTo(const QString& path) {
  if (!tell(workspace_.document().save(path))) {
    return false;
  }
  memory_.noteFile(path);
  Q_EMIT recentChanged();
  return true;
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
  const QString path = QFileDialog::getOpenFileName(&window_, tr("Open a scenario or a map"),
                                                    folder(), tr("YAML files (*.yaml *.yml)"));
  if (!path.isEmpty() && mayLeave()) {
    openFile(path);
  }
}

void FileCommands::askNewFromMap() {
  const QString path = QFileDialog::getOpenFileName(&window_, tr("New scenario on a map"), folder(),
                                                    tr("Maps (*.yaml *.yml)"));
  if (!path.isEmpty() && mayLeave()) {
    openNewFromMap(path);
  }
}

void FileCommands::askOtherMap() {
  const QString path = QFileDialog::getOpenFileName(&window_, tr("Put a map under the scenario"),
                                                    folder(), tr("Maps (*.yaml *.yml)"));
  if (!path.isEmpty()) {
    tell(workspace_.document().openMap(path));
  }
}

bool FileCommands::save() {
  editor::ScenarioDocument& document = workspace_.document();
  if (document.path().isEmpty()) {
    return saveAs();
  }
  if (document.commentCount() > 0) {
    const auto answer =
        QMessageBox::question(&window_, tr("Comments will be lost"),
                              tr("%1 has %n comment(s) that saving does not keep. Save over it?",
                                 nullptr, document.commentCount())
                                  .arg(document.displayName()),
                              QMessageBox::Save | QMessageBox::Cancel, QMessageBox::Cancel);
    if (answer != QMessageBox::Save) {
      return false;
    }
  }
  return saveTo(document.path());
}

bool FileCommands::saveAs() {
  const QString proposal = workspace_.document().path().isEmpty()
                               ? folder() + QStringLiteral("/scenario.yaml")
                               : workspace_.document().path();
  QString path = QFileDialog::getSaveFileName(&window_, tr("Save the scenario"), proposal,
                                              tr("Scenarios (*.yaml)"));
  if (path.isEmpty()) {
    return false;
  }
  if (QFileInfo(path).suffix().isEmpty()) {
    path += QStringLiteral(".yaml");
  }
  return saveTo(path);
}

bool FileCommands::mayLeave() {
  editor::ScenarioDocument& document = workspace_.document();
  if (!document.isDirty()) {
    return true;
  }
  const auto answer = QMessageBox::question(
      &window_, tr("Unsaved changes"),
      tr("Save the changes to %1 first?").arg(document.displayName()),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
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
