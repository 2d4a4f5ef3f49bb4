#include "editor/look/FileDialog.h"

#include <QtWidgets>

#include "editor/look/PendingEdit.h"

namespace editor {

namespace {

/// Renames a file after the current event. Qt reports a failure in a modal dialog, during which the
/// item editor may be deleted; Qt 5.15 then reads freed memory.
class NamingDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void setModelData(QWidget* editor, QAbstractItemModel* model,
                    const QModelIndex& index) const override {
    const auto* const line = qobject_cast<QLineEdit*>(editor);
    auto* const files = qobject_cast<QFileSystemModel*>(model);
    if (line == nullptr || files == nullptr) {
      QStyledItemDelegate::setModelData(editor, model, index);
      return;
    }
    // Looks the index up by path, because the model may have reloaded the folder.
    QTimer::singleShot(0, files, [files, name = line->text(), path = files->filePath(index)] {
      files->setData(files->index(path), name);
    });
  }
};

}  // namespace

void restrictFileDialog(QFileDialog& dialog, bool allowNewFolders) {
  if (!allowNewFolders) {
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
          QAbstractItemView::NoEditTriggers);  // A new folder can be named nevertheless.
      files->setDragDropMode(QAbstractItemView::NoDragDrop);
      files->setItemDelegate(new NamingDelegate(files));
      // Commits the name of a new folder before the folder changes: Qt 5.15 reads freed memory if
      // the user leaves the folder while typing.
      for (QToolButton* button : dialog.findChildren<QToolButton*>()) {
        QObject::connect(button, &QToolButton::pressed, files,
                         [files] { commitPendingEdit(*files); });
      }
    }
  }
}

QStringList chosenFiles(QFileDialog& dialog, bool allowNewFolders) {
  restrictFileDialog(dialog, allowNewFolders);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles() : QStringList();
}

}  // namespace editor
