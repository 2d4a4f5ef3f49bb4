#pragma once

class QLayout;
class QMenu;

namespace editor {

/// Takes everything out. The parts are deleted after the current event: one of them may be the
/// action or button that the event came from.
void clearLater(QMenu& menu);
void clearLater(QLayout& layout);

}  // namespace editor
