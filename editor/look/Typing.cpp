#include "editor/look/Typing.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPointer>

namespace editor {

namespace {

/// At most one: a list edits one row at a time.
QWidget* openField(const QAbstractItemView& list) {
  for (QWidget* each :
       list.viewport()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    const bool isField =
        qobject_cast<QLineEdit*>(each) != nullptr || qobject_cast<QComboBox*>(each) != nullptr;
    if (isField && !each->isHidden()) {  // else it is about to be deleted
      return each;
    }
  }
  return nullptr;
}

}  // namespace

void finishTyping(QWidget& window) {
  const QPointer<QWidget> field = window.focusWidget();
  const bool isField = qobject_cast<QLineEdit*>(field) != nullptr ||
                       qobject_cast<QAbstractSpinBox*>(field) != nullptr ||
                       qobject_cast<QPlainTextEdit*>(field) != nullptr;
  if (!isField || !field->hasFocus()) {
    return;  // a menu or dialog that took the keyboard has committed the text
  }
  field->clearFocus();
  if (field && field->isVisible()) {  // a field in a list is already closed
    field->setFocus();
  }
}

void finishTyping(const QAbstractItemView& list) {
  if (QWidget* const field = openField(list)) {
    Q_EMIT list.itemDelegate()->commitData(field);
    Q_EMIT list.itemDelegate()->closeEditor(field);
  }
}

void dropTyping(const QAbstractItemView& list) {
  if (QWidget* const field = openField(list)) {
    Q_EMIT list.itemDelegate()->closeEditor(field, QAbstractItemDelegate::RevertModelCache);
  }
}

}  // namespace editor
