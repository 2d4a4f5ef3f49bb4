#include "editor/look/PendingEdit.h"

#include <QtWidgets>

namespace editor {

namespace {

/// The open item editor, or null. A list edits one row at a time.
QWidget* openEditor(const QAbstractItemView& list) {
  for (QWidget* each :
       list.viewport()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    const bool isField =
        qobject_cast<QLineEdit*>(each) != nullptr || qobject_cast<QComboBox*>(each) != nullptr;
    if (isField && !each->isHidden()) {  // Hidden editors are about to be deleted.
      return each;
    }
  }
  return nullptr;
}

}  // namespace

void commitPendingEdit(QWidget& window) {
  const QPointer<QWidget> field = window.focusWidget();
  const bool isField = qobject_cast<QLineEdit*>(field) != nullptr ||
                       qobject_cast<QAbstractSpinBox*>(field) != nullptr ||
                       qobject_cast<QPlainTextEdit*>(field) != nullptr;
  if (!isField || !field->hasFocus()) {
    return;  // The menu or dialog that took the focus has already committed the text.
  }
  field->clearFocus();
  if (field && field->isVisible()) {  // An editor in a list has already been closed.
    field->setFocus();
  }
}

void commitPendingEdit(const QAbstractItemView& list) {
  if (QWidget* const field = openEditor(list)) {
    Q_EMIT list.itemDelegate()->commitData(field);
    Q_EMIT list.itemDelegate()->closeEditor(field);
  }
}

void cancelPendingEdit(const QAbstractItemView& list) {
  if (QWidget* const field = openEditor(list)) {
    Q_EMIT list.itemDelegate()->closeEditor(field, QAbstractItemDelegate::RevertModelCache);
  }
}

}  // namespace editor
