// File > Export…
#include <QFileInfo>

#include "app/window/ExportDialog.h"
#include "app/window/FileCommands.h"
#include "editor/document/DocumentSnapshot.h"
#include "sim2d/base/Text.h"

namespace app {

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
  for (const sim2d::Human& human : source.scenario.humans) {
    if (std::optional<std::string> tree = document.treeToRun(human.key)) {
      source.trees[human.name] = {*std::move(tree), source.path};
    }
  }
  return source;
}

void FileCommands::askExport() {
  constexpr const char* kFolderKey = "files/export";
  const QString last = memory_.value(kFolderKey).toString();
  ExportDialog dialog(exportSource(), last.isEmpty() ? folder() + QStringLiteral("/export") : last,
                      workspace_.theme(), &window_);
  if (dialog.exec() == QDialog::Accepted) {
    memory_.setValue(kFolderKey, dialog.folder());
    exportPlan(dialog.plan());
  }
}

bool FileCommands::exportPlan(const ExportPlan& plan) {
  return tell(writeExport(plan));
}

}  // namespace app
