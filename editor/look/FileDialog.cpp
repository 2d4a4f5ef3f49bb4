#include "editor/look/FileDialog.h"

#include <QAbstractItemView>
#include <QAction>
#include <QLineEdit>
#include <QShortcut>
#include <QToolButton>

namespace editor {

namespace {

/// The name that is being typed in the list of files, of a new folder, is taken as it is.
void takeName(const QAbstractItemView& files) {
  for (QLineEdit* name : files.viewport()->findChildren<QLineEdit*>()) {
    Q_EMIT files.itemDelegate()->commitData(name);
    Q_EMIT files.itemDelegate()->closeEditor(name);
  }
}

}  // namespace

void keepFiles(QFileDialog& dialog, bool makesFolders) {
  if (!makesFolders) {
    dialog.setOption(QFileDialog::ReadOnly);
    return;
  }
  for (const char* name : {"qt_delete_action", "qt_rename_action"}) {
    if (auto* action = dialog.findChild<QAction*>(QString::fromLatin1(name))) {
      action->setVisible(false);
    }
  }
  for (QShortcut* shortcut : dialog.findChildren<QShortcut*>()) {
    shortcut->setEnabled(shortcut->key() != QKeySequence(Qt::Key_Delete));
  }
  for (const char* name : {"listView", "treeView"}) {
    if (auto* files = dialog.findChild<QAbstractItemView*>(QString::fromLatin1(name))) {
      files->setEditTriggers(
          QAbstractItemView::NoEditTriggers);  // a new folder is named all the same
      files->setDragDropMode(QAbstractItemView::NoDragDrop);
      // Qt 5.15 reads freed memory when the folder is left meanwhile.
      for (QToolButton* button : dialog.findChildren<QToolButton*>()) {
        QObject::connect(button, &QToolButton::pressed, files, [files] { takeName(*files); });
      }
    }
  }
}

}  // namespace editor
