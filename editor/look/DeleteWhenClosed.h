#pragma once

class QDialog;

namespace editor {

/// Like Qt::WA_DeleteOnClose, but never during a drag out of the dialog: Qt comes back to the list
/// that the drag began in, and does not notice that it is gone. Thread: that of the window.
void deleteWhenClosed(QDialog& dialog);

}  // namespace editor
