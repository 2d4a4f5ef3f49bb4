#pragma once

#include <QFileDialog>

namespace editor {

/// Nothing can be deleted, renamed or moved in the dialog; new folders can be made in one that
/// `makesFolders`. Dialogs of the desktop see to themselves. Before it is shown.
void keepFiles(QFileDialog& dialog, bool makesFolders);

}  // namespace editor
