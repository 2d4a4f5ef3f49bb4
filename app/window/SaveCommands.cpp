// Saving, and the questions before something is lost.
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "app/window/FileCommands.h"
#include "app/window/TreeChoiceDialog.h"

namespace app {

bool FileCommands::saveTo(const QString& path, const editor::TreeAnswers& trees) {
  if (!tell(workspace_.document().save(path, trees))) {
    return false;
  }
  memory_.noteFile(path);
  Q_EMIT recentChanged();
  return true;
}

/// One box with all that saving over the file would lose.
bool FileCommands::mayWriteOver() {
  const editor::ScenarioDocument& document = workspace_.document();
  QStringList losses;
  if (document.changedOnDisk().contains(document.path())) {
    losses << tr("Another program has changed %1 since it was opened; saving replaces what it "
                 "wrote.")
                  .arg(document.displayName());
  }
  if (document.commentCount() > 0) {
    losses << (document.commentCount() == 1
                   ? tr("%1 has a comment, which saving does not keep.").arg(document.displayName())
                   : tr("%1 has %2 comments, which saving does not keep.")
                         .arg(document.displayName())
                         .arg(document.commentCount()));
  }
  return losses.isEmpty() || QMessageBox::question(&window_, tr("Save over the file?"),
                                                   losses.join(QStringLiteral("\n\n")),
                                                   QMessageBox::Save | QMessageBox::Cancel,
                                                   QMessageBox::Cancel) == QMessageBox::Save;
}

bool FileCommands::saveAsking(const QString& path) {
  const std::optional<editor::TreeAnswers> trees = TreeChoiceDialog::ask(
      workspace_.document().treeQuestions(path), workspace_.theme(), &window_);
  return trees && saveTo(path, *trees);
}

bool FileCommands::save() {
  const editor::ScenarioDocument& document = workspace_.document();
  if (document.path().isEmpty() || document.isReadOnly()) {
    return saveAs();
  }
  return mayWriteOver() && saveAsking(document.path());
}

bool FileCommands::saveAs() {
  const editor::ScenarioDocument& document = workspace_.document();
  const QFileInfo old(document.path());
  const QString proposal =
      document.path().isEmpty() ? folder() + QStringLiteral("/scenario.yaml")
      : document.isReadOnly()
          ? old.dir().filePath(old.completeBaseName() + QStringLiteral("_repaired.yaml"))
          : document.path();
  QString path = QFileDialog::getSaveFileName(&window_, tr("Save the scenario"), proposal,
                                              tr("Scenarios (*.yaml)"));
  if (path.isEmpty()) {
    return false;
  }
  if (QFileInfo(path).suffix().isEmpty()) {
    path += QStringLiteral(".yaml");
  }
  return saveAsking(path);
}

bool FileCommands::mayLeave() {
  const editor::ScenarioDocument& document = workspace_.document();
  if (!document.isDirty()) {
    return true;
  }
  const auto answer = QMessageBox::question(
      &window_, tr("Unsaved changes"),
      tr("Save the changes to %1 first?").arg(document.displayName()),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

}  // namespace app
