#pragma once

#include <functional>

#include <QObject>

#include "app/window/Docks.h"
#include "app/window/NoticeBar.h"
#include "app/window/Workspace.h"

namespace app {

/// What the window does for the tree editor: reports a refused run at the faulty node, and saves
/// the picture of a tree.
class TreeCommands : public QObject {
  Q_OBJECT
 public:
  TreeCommands(Workspace& workspace, Docks& docks, NoticeBar& notices, QWidget& window);

 Q_SIGNALS:
  void message(const QString& text);  // For the status bar.
  void issuesRequested();             // Requests showing the list of issues.

 private:
  void showRefusedRun(const base::Diagnostics& problems);
  void dropIssuesAtStart();
  void savePicture(editor::EntityId person);

  Workspace& workspace_;
  Docks& docks_;
  NoticeBar& notices_;
  QWidget& window_;
  bool isEditing_ = true;  // State of the runner at its last change.
};

}  // namespace app
