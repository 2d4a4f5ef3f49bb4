#include "editor/look/DeferredActions.h"

#include <memory>

namespace editor {

void later(QObject& context, const std::function<void()>& action, int milliseconds) {
  auto* timer = new QTimer(&context);
  timer->setSingleShot(true);
  QObject::connect(timer, &QTimer::timeout, &context, [timer, action] {
    timer->deleteLater();
    action();
  });
  timer->start(milliseconds);
}

void clearLater(QMenu& menu) {
  for (QAction* action : menu.actions()) {
    menu.removeAction(action);
    if (action->parent() == &menu) {  // Other actions belong to the window.
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

void deleteWhenClosed(QDialog& dialog) {
  QObject::connect(&dialog, &QDialog::finished, &dialog, [&dialog] {
    // The parent of the drag is the widget in which it began. Qt deletes the drag on its return to
    // that widget.
    if (const auto* drag = dialog.findChild<QDrag*>()) {
      QObject::connect(drag, &QObject::destroyed, &dialog, &QObject::deleteLater);
    } else {
      dialog.deleteLater();
    }
  });
}

QMenu& PanelMenu::begin(QWidget& owner) {
  close();
  menu_ = new QMenu(&owner);
  menu_->setAttribute(Qt::WA_DeleteOnClose);
  return *menu_;
}

}  // namespace editor
