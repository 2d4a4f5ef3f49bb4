
#include "app/window/files/FileCommands.h"
#include "app/window/files/MapFiles.h"
#include "editor/document/Autosave.h"
#include "editor/look/Fields.h"

/// The part of FileCommands that saves and exports, with the questions before data is lost.
namespace app {

namespace {

constexpr const char* kExportKey = "files/export";  // scenario and its export folder

}  // namespace

bool FileCommands::saveTo(const QString& path, const editor::TreeReplacements& trees) {
  const base::Diagnostics problems = workspace_.document().save(path, trees);
  if (base::hasErrors(problems)) {
    problems_ = problems;
    Q_EMIT notSaved(QFileInfo(path).fileName(), problems);
    return false;
  }
  showProblems(problems);
  userSettings_.addRecentFile(path);
  Q_EMIT recentChanged();
  Q_EMIT message(tr("Saved %1").arg(QFileInfo(path).fileName()));
  return true;
}

/// One message box with everything that saving over the file would lose.
bool FileCommands::confirmOverwrite() {
  const editor::ScenarioDocument& document = workspace_.document();
  QStringList losses;
  if (document.changedOnDisk().contains(document.path())) {
    losses << tr("%1 was changed by another program after it was opened; saving overwrites those "
                 "changes.")
                  .arg(document.displayName());
  }
  if (document.commentCount() > 0) {
    losses
        << (document.commentCount() == 1
                ? tr("%1 has a comment, which is lost when you save.").arg(document.displayName())
                : tr("%1 has %2 comments, which are lost when you save.")
                      .arg(document.displayName())
                      .arg(document.commentCount()));
  }
  if (losses.isEmpty()) {
    return true;
  }
  losses << tr("Save anyway?");
  return QMessageBox::question(
             &window_, tr("Overwrite the file?"), losses.join(QStringLiteral("\n\n")),
             QMessageBox::Save | QMessageBox::Cancel, QMessageBox::Cancel) == QMessageBox::Save;
}

bool FileCommands::saveAsking(const QString& path) {
  const std::optional<editor::TreeReplacements> trees = TreeChoiceDialog::ask(
      workspace_.document().treeConflicts(path), workspace_.theme(), &window_);
  return trees && saveTo(path, *trees);
}

bool FileCommands::save() {
  editor::commitPendingEdit(window_);
  const editor::ScenarioDocument& document = workspace_.document();
  if (document.path().isEmpty() || document.isReadOnly()) {
    return saveAs();
  }
  return confirmOverwrite() && saveAsking(document.path());
}

QString FileCommands::suggestedPath() const {
  const editor::ScenarioDocument& document = workspace_.document();
  const QFileInfo old(document.path());
  if (document.path().isEmpty()) {
    const QString name =
        document.mapPath().isEmpty()
            ? QStringLiteral("scenario")
            : QFileInfo(document.mapPath()).completeBaseName() + QStringLiteral("_agents");
    return QDir(folder()).filePath(name + QStringLiteral(".yaml"));
  }
  if (document.isShipped(document.path())) {
    return QDir(folder()).filePath(old.fileName());
  }
  return document.isReadOnly()
             ? old.dir().filePath(old.completeBaseName() + QStringLiteral("_repaired.yaml"))
             : document.path();
}

bool FileCommands::saveAs() {
  const QFileInfo proposed(suggestedPath());
  QFileDialog dialog(&window_, tr("Save the scenario"), proposed.absolutePath(),
                     tr("Scenarios (*.yaml)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("yaml"));
  dialog.selectFile(proposed.fileName());
  const QString path = askFile(dialog, userSettings_);
  return !path.isEmpty() && saveAsPath(path);
}

/// Whether the file is the current map, another map, or an image.
bool FileCommands::isMap(const QString& path) const {
  const QString map = workspace_.document().mapPath();
  if (!map.isEmpty() && isSameFile(QFileInfo(path), QFileInfo(map))) {
    return true;
  }
  if (!QFileInfo::exists(path)) {
    return false;
  }
  return kindOf(path) == Kind::Image || isMapYaml(path) ||
         (!map.isEmpty() && isSameFile(QFileInfo(path), QFileInfo(imageOf(map))));
}

bool FileCommands::saveAsPath(const QString& path) {
  if (isMap(path)) {
    QMessageBox::warning(
        &window_, tr("This file is a map"),
        tr("%1 is a map or a map image. Saving the scenario there would overwrite it. Choose "
           "another name, such as %2.")
            .arg(QFileInfo(path).fileName(), QFileInfo(suggestedPath()).fileName()));
    return false;
  }
  return saveAsking(path);
}

bool FileCommands::isFileMissing() const {
  const QString path = workspace_.document().path();
  return !path.isEmpty() && !QFileInfo::exists(path);
}

bool FileCommands::maybeSave() {
  editor::commitPendingEdit(window_);
  const editor::ScenarioDocument& document = workspace_.document();
  if (!document.isDirty() && !isFileMissing()) {
    return true;
  }
  const auto answer = QMessageBox::question(
      &window_, document.isDirty() ? tr("Unsaved changes") : tr("File not found"),
      (document.isDirty() ? tr("Save the changes to %1 first?")
                          : tr("%1 was moved or deleted. Save it again first?"))
          .arg(document.displayName()),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

/// The current document, saved or not.
Bundle FileCommands::exportSource() const {
  const editor::ScenarioDocument& document = workspace_.document();
  Bundle source;
  source.scenario = std::make_shared<const sim2d::Scenario>(document.scenario());
  source.path = document.path().toStdString();
  source.map = document.map();
  const bool isInFile = document.snapshot().mapIsInFile;
  source.mapPath = isInFile ? document.mapPath().toStdString() : std::string();
  source.comments = document.commentCount();
  source.remarks = document.mapState().problems;
  for (const sim2d::Human& human : source.scenario->humans) {
    if (std::optional<std::string> tree = document.treeToRun(human.key)) {
      source.trees[human.name] = {*std::move(tree), source.path, {}};
    }
  }
  return source;
}

/// The folder of the scenario's last export, otherwise next to the scenario.
QString FileCommands::exportFolder() const {
  const QString path = workspace_.document().path();
  const QStringList last = userSettings_.value(kExportKey).toStringList();
  const bool isOurs = last.size() == 2 && !path.isEmpty() && last.front() == path;
  return isOurs ? last.back() : folder() + QStringLiteral("/export");
}

void FileCommands::askExport() {
  ExportDialog dialog(exportSource(), exportFolder(), workspace_.theme(), &window_);
  if (dialog.exec() == QDialog::Accepted && exportPlan(dialog.plan())) {
    userSettings_.setValue(kExportKey, QStringList{workspace_.document().path(), dialog.folder()});
  }
}

bool FileCommands::exportPlan(const ExportPlan& plan) {
  problems_ = writeExport(plan);
  if (base::hasErrors(problems_)) {
    Q_EMIT notExported(problems_);
    return false;
  }
  const QString scenario = QString::fromStdString(plan.files.front().content.path);
  Q_EMIT exported(QDir::cleanPath(QFileInfo(scenario).absolutePath() + QStringLiteral("/..")),
                  static_cast<int>(plan.files.size()));
  return true;
}

}  // namespace app
