#include "app/window/TreeCommands.h"

#include <utility>

#include <QFileDialog>
#include <QRegularExpression>

#include "app/cli/TreePictureFile.h"
#include "editor/document/PersonTree.h"
#include "editor/look/Form.h"
#include "editor/trees/TreeEditor.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr const char* kPictureNotice = "tree-picture";

/// "Ana B." -> "Ana_B_tree.svg"
QString proposedName(const std::string& person) {
  QString name = QString::fromStdString(person);
  name.replace(QRegularExpression(QStringLiteral("[^\\w-]+")), QStringLiteral("_"));
  return name + QStringLiteral("_tree.svg");
}

/// The chosen file; empty: cancelled.
QString askForPicture(const QString& folder, const QString& name, QWidget& window) {
  QFileDialog dialog(&window, QObject::tr("Save the picture of the tree"), folder);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilters({QObject::tr("Vector graphics (*.svg)"), QObject::tr("Document (*.pdf)"),
                         QObject::tr("Image (*.png)")});
  const auto useEnding = [&dialog](const QString& filter) {
    dialog.setDefaultSuffix(filter.section(QStringLiteral("*."), 1).left(3));
  };
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, useEnding);
  useEnding(dialog.nameFilters().front());
  dialog.selectFile(name);
  return editor::chosenFiles(dialog, true).value(0);
}

}  // namespace

TreeCommands::TreeCommands(Workspace& workspace, Docks& docks, NoticeBar& notices, QWidget& window)
    : QObject(&docks), workspace_(workspace), docks_(docks), notices_(notices), window_(window) {
  connect(&workspace_.runner(), &editor::SimulationRunner::notStarted, this,
          &TreeCommands::showRefusedRun);
  connect(&workspace_.runner(), &editor::SimulationRunner::stateChanged, this,
          &TreeCommands::dropIssuesAtStart);
  connect(&docks_.context(), &editor::PanelContext::treePictureRequested, this,
          &TreeCommands::savePicture);
}

/// An error of a tree is shown at its node if the tree editor is open; others in the list of
/// issues. The large tree editor stays open in any case: it shows the first error above the tree.
void TreeCommands::showRefusedRun(const base::Diagnostics& problems) {
  Q_EMIT docks_.context().problemsFound(problems);
  Q_EMIT message(editor::refusedRunText(problems));
  auto& trees = docks_.panel<editor::TreeEditor>();
  const bool isShownThere = trees.isVisible() && trees.showRefusedRun(problems);
  if (!isShownThere && !docks_.treeMaximized()->isChecked()) {
    Q_EMIT issuesRequested();
  }
}

/// A run that starts has its own issues.
void TreeCommands::dropIssuesAtStart() {
  const editor::SimulationRunner& runner = workspace_.runner();
  const bool isEditing = runner.state() == editor::SimulationRunner::State::Editing;
  if (std::exchange(isEditing_, isEditing) && !isEditing && !runner.isRecorded()) {
    Q_EMIT docks_.context().problemsFound({});
  }
}

void TreeCommands::savePicture(editor::EntityId person) {
  const sim2d::Human* human = workspace_.document().human(person);
  if (human == nullptr) {
    return;
  }
  const bt::TreeTable trees = editor::personTree(workspace_.document(), person).table;
  const auto& graph = docks_.panel<editor::TreeEditor>().canvas().graph();
  const std::string path =
      askForPicture(docks_.context().folder(), proposedName(human->name), window_).toStdString();
  if (path.empty()) {
    return;
  }
  const base::Result<std::string> bytes = treePictureBytes(trees, path, graph.direction());
  const base::Diagnostics problems =
      bytes ? base::writeFileAtomically(path, *bytes) : bytes.diagnostics();
  if (base::hasErrors(problems)) {
    notices_.warn(QString::fromLatin1(kPictureNotice),
                  QString::fromStdString(problems.front().text()));
    return;
  }
  notices_.drop(QString::fromLatin1(kPictureNotice));
  Q_EMIT message(tr("Saved %1").arg(QString::fromStdString(path)));
}

}  // namespace app
