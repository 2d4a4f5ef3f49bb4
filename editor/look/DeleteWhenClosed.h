#pragma once

class QDialog;

namespace editor {

/// Like Qt::WA_DeleteOnClose, but never inside of an event loop that was begun after this call:
/// what is dragged out of a dialog comes back to it when the drag is over, and Qt does not notice
/// that it is gone. A dialog that is shown again meanwhile stays. Thread: that of the window.
void deleteWhenClosed(QDialog& dialog);

}  // namespace editor
