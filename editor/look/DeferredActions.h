#pragma once

#include <functional>

#include <QtWidgets>

namespace editor {

/// Calls `action` after the pending events, or after `milliseconds`, unless `context` has been
/// deleted. Thread: GUI.
void later(QObject& context, const std::function<void()>& action, int milliseconds = 0);

/// Removes all items and deletes them after the current event, because one of them may be the
/// action or button that sent the event.
void clearLater(QMenu& menu);
void clearLater(QLayout& layout);

/// Like Qt::WA_DeleteOnClose, but defers the deletion while a drag out of the dialog is active: Qt
/// returns to the list in which the drag began without checking that it still exists. Thread: GUI.
void deleteWhenClosed(QDialog& dialog);

/// The open context menu of a panel, at most one at a time. It is deleted after closing. The panel
/// closes it when its subject is replaced, for example because a running simulation selects another
/// person.
class PanelMenu {
 public:
  /// Replaces the menu with an empty one; `owner` is its parent.
  QMenu& begin(QWidget& owner);
  void close() {
    if (menu_) {
      menu_->close();
    }
  }

 private:
  QPointer<QMenu> menu_;
};

}  // namespace editor
