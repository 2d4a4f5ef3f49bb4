#pragma once

#include <QFileDialog>

namespace editor {

/// Disables deleting, renaming and moving files in the dialog; new folders are allowed if
/// `allowNewFolders`. Call it before the dialog is shown. Native desktop dialogs are not affected.
void restrictFileDialog(QFileDialog& dialog, bool allowNewFolders);
/// Shows the restricted dialog. Returns the chosen files; empty: cancelled.
QStringList chosenFiles(QFileDialog& dialog, bool allowNewFolders);

}  // namespace editor
