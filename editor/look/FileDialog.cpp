#include "editor/look/FileDialog.h"

#include <QAbstractItemView>
#include <QAction>
#include <QFileSystemModel>
#include <QLineEdit>
#include <QShortcut>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QToolButton>

#include "editor/look/Typing.h"

namespace editor {

namespace {

/// Names files a moment later. What cannot be done is told in a dialog, in whose time the editor
/// may go: Qt 5.15 would read freed memory afterwards.
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
    // By its path: the model may have read the folder again.
    QTimer::singleShot(0, files, [files, name = line->text(), path = files->filePath(index)] {
      files->setData(files->index(path), name);
    });
  }
};

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
      files->setItemDelegate(new NamingDelegate(files));
      // The name of a new folder is taken as it is: Qt 5.15 reads freed memory when the folder is
      // left while it is being typed.
      for (QToolButton* button : dialog.findChildren<QToolButton*>()) {
        QObject::connect(button, &QToolButton::pressed, files, [files] { finishTyping(*files); });
      }
    }
  }
}

}  // namespace editor
