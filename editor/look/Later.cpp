#include "editor/look/Later.h"

#include <QTimer>

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

}  // namespace editor
