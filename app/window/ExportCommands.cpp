// File > Export…
#include <QDir>
#include <QFileInfo>

#include "app/window/ExportDialog.h"
#include "app/window/FileCommands.h"
#include "editor/document/DocumentSnapshot.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr const char* kExportKey = "files/export";  // a scenario and its folder

}  // namespace

/// The document as it is in the window, saved or not.
ExportSource FileCommands::exportSource() const {
  const editor::ScenarioDocument& document = workspace_.document();
  ExportSource source;
  source.scenario = document.scenario();
  source.path = document.path().toStdString();
  source.map = document.map();
  const bool isInFile = document.snapshot().mapIsInFile;
  source.mapPath = isInFile ? document.mapPath().toStdString() : std::string();
  source.comments = document.commentCount();
  source.problems = document.mapState().problems;
  for (const sim2d::Human& human : source.scenario.humans) {
    if (std::optional<std::string> tree = document.treeToRun(human.key)) {
      source.trees[human.name] = {*std::move(tree), source.path};
    }
  }
  return source;
}

/// Where this scenario was exported last, else beside it.
QString FileCommands::exportFolder() const {
  const QString path = workspace_.document().path();
  const QStringList last = memory_.value(kExportKey).toStringList();
  const bool isOurs = last.size() == 2 && !path.isEmpty() && last.front() == path;
  return isOurs ? last.back() : folder() + QStringLiteral("/export");
}

void FileCommands::askExport() {
  ExportDialog dialog(exportSource(), exportFolder(), workspace_.theme(), &window_);
  if (dialog.exec() == QDialog::Accepted && exportPlan(dialog.plan())) {
    memory_.setValue(kExportKey, QStringList{workspace_.document().path(), dialog.folder()});
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
