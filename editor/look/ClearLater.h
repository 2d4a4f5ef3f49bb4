#pragma once

class QLayout;
class QMenu;

namespace editor {

/// Removes all items. They are deleted after the current event: one of them may be the action or
/// button that sent the event.
void clearLater(QMenu& menu);
void clearLater(QLayout& layout);

}  // namespace editor
