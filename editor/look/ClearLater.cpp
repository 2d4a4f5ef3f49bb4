#include "editor/look/ClearLater.h"

#include <memory>

#include <QLayout>
#include <QMenu>

namespace editor {

void clearLater(QMenu& menu) {
  for (QAction* action : menu.actions()) {
    menu.removeAction(action);
    if (action->parent() == &menu) {  // else it belongs to the window
      action->deleteLater();
    }
  }
}

void clearLater(QLayout& layout) {
  while (const std::unique_ptr<QLayoutItem> item{layout.takeAt(0)}) {
    if (QWidget* widget = item->widget()) {
      widget->hide();
      widget->deleteLater();
    }
  }
}

}  // namespace editor
