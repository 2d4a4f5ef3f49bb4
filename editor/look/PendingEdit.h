#pragma once

class QAbstractItemView;
class QWidget;

namespace editor {

/// Commits the text being typed in a field of the window, as losing the focus does. The field keeps
/// the focus.
void commitPendingEdit(QWidget& window);
/// Commits the text being typed in a row of the list and closes the editor.
void commitPendingEdit(const QAbstractItemView& list);
/// Closes the editor without a commit before its row is replaced; otherwise Qt commits during the
/// replacement.
void cancelPendingEdit(const QAbstractItemView& list);

}  // namespace editor
