#include "app/window/FileDrop.h"

#include <QDragEnterEvent>
#include <QMimeData>
#include <QTimer>
#include <QUrl>

namespace app {

FileDrop::FileDrop(Workspace& workspace, FileCommands& files, QWidget& window)
    : QObject(&window), workspace_(workspace), files_(files), window_(window) {
  window.setAcceptDrops(true);
  window.installEventFilter(this);
}

bool FileDrop::eventFilter(QObject* window, QEvent* event) {
  if (event->type() == QEvent::DragEnter) {
    auto* enter = static_cast<QDragEnterEvent*>(event);
    const QList<QUrl> urls = enter->mimeData()->urls();
    if (urls.size() == 1 && urls.front().isLocalFile()) {
      enter->acceptProposedAction();
    }
    return true;
  }
  if (event->type() == QEvent::Drop) {
    auto* drop = static_cast<QDropEvent*>(event);
    drop->acceptProposedAction();
    // later: the program that drags waits until this is through, and there may be questions
    QTimer::singleShot(0, &files_,
                       [this, path = drop->mimeData()->urls().front().toLocalFile(),
                        person = under(drop->pos())] { files_.dropFile(path, person); });
    return true;
  }
  return QObject::eventFilter(window, event);
}

editor::EntityId FileDrop::under(const QPoint& place) const {
  const editor::MapView& view = workspace_.view();
  if (!view.isVisible() || !view.rect().contains(view.mapFrom(&window_, place))) {
    return {};
  }
  const QPointF scene = view.mapToScene(view.viewport()->mapFrom(&window_, place));
  return workspace_.scene().entityAt(editor::MapScene::worldFromScene(scene));
}

}  // namespace app
