#include "editor/look/FileDialog.h"

#include <QAbstractItemView>
#include <QAction>
#include <QShortcut>

namespace editor {

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
    }
  }
}

}  // namespace editor
