#pragma once

#include <memory>

#include <QAbstractItemView>
#include <QApplication>
#include <QDropEvent>
#include <QMimeData>

/// What happens when rows are dragged over and let go: the platform without a screen knows no
/// drags, so the view gets the events that end one.
inline void dropRows(QAbstractItemView& from, const QModelIndexList& rows, QAbstractItemView& to,
                     const QPoint& at, Qt::DropAction action) {
  const std::unique_ptr<QMimeData> data(from.model()->mimeData(rows));
  QDragEnterEvent enter(at, action, data.get(), Qt::LeftButton, {});
  QApplication::sendEvent(to.viewport(), &enter);
  QDragMoveEvent move(at, action, data.get(), Qt::LeftButton, {});
  QApplication::sendEvent(to.viewport(), &move);
  if (move.isAccepted()) {
    QDropEvent drop(at, action, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(to.viewport(), &drop);
  }
}
