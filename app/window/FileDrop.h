#pragma once

#include "app/window/FileCommands.h"

namespace app {

/// A file that is dropped onto the window: opened, or given to the person it falls on.
class FileDrop : public QObject {
  Q_OBJECT
 public:
  FileDrop(Workspace& workspace, FileCommands& files, QWidget& window);

 protected:
  bool eventFilter(QObject* window, QEvent* event) override;

 private:
  editor::EntityId under(const QPoint& place) const;  // of the window

  Workspace& workspace_;
  FileCommands& files_;
  QWidget& window_;
};

}  // namespace app
