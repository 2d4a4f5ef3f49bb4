#include "editor/look/DeleteWhenClosed.h"

#include <QDialog>
#include <QThread>
#include <QTimer>

namespace editor {

void deleteWhenClosed(QDialog& dialog) {
  constexpr int kLookMs = 20;
  const int level = QThread::currentThread()->loopLevel();
  auto* timer = new QTimer(&dialog);
  timer->setInterval(kLookMs);
  QObject::connect(&dialog, &QDialog::finished, timer, [timer] { timer->start(); });
  QObject::connect(timer, &QTimer::timeout, &dialog, [&dialog, timer, level] {
    if (dialog.isVisible()) {
      timer->stop();
    } else if (QThread::currentThread()->loopLevel() <= level) {
      dialog.deleteLater();
    }
  });
}

}  // namespace editor
