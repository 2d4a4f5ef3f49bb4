#include "editor/look/PanelMenu.h"

namespace editor {

QMenu& PanelMenu::begin(QWidget& owner) {
  close();
  menu_ = new QMenu(&owner);
  menu_->setAttribute(Qt::WA_DeleteOnClose);
  return *menu_;
}

void PanelMenu::close() {
  if (menu_) {
    menu_->close();
  }
}

}  // namespace editor
