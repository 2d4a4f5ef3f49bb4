#pragma once

#include <QAction>

namespace editor {

/// What a command says of itself: the sentence in the status bar, and in its tooltip below its name
/// and its key. Call it again when one of them changes.
void describe(QAction& action, const QString& says);

}  // namespace editor
