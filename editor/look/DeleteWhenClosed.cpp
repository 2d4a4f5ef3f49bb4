#include "editor/look/DeleteWhenClosed.h"

#include <QDialog>
#include <QDrag>

namespace editor {

void deleteWhenClosed(QDialog& dialog) {
  QObject::connect(&dialog, &QDialog::finished, &dialog, [&dialog] {
    // Its parent is where it began; Qt deletes it when it has come back there.
    if (const auto* drag = dialog.findChild<QDrag*>()) {
      QObject::connect(drag, &QObject::destroyed, &dialog, &QObject::deleteLater);
    } else {
      dialog.deleteLater();
    }
  });
}

}  // namespace editor
