#pragma once

class QAbstractItemView;
class QWidget;

namespace editor {

/// Commits what is being typed in a field of the window, as leaving the field does. The field keeps
/// the keyboard.
void finishTyping(QWidget& window);
/// Commits what is being typed in a row of the list, and closes the field.
void finishTyping(const QAbstractItemView& list);
/// Closes the field without a commit, before its row is replaced: Qt would commit in the middle.
void dropTyping(const QAbstractItemView& list);

}  // namespace editor
