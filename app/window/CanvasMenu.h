#pragma once

#include <QObject>

#include "app/window/Docks.h"
#include "app/window/WindowActions.h"
#include "app/window/Workspace.h"

namespace app {

/// The menu of the right mouse button on the map, while the tool to select is at hand: other tools
/// end their lines with that button. GUI thread.
class CanvasMenu : public QObject {
  Q_OBJECT
 public:
  CanvasMenu(Workspace& workspace, WindowActions& actions, Docks& docks, QObject* parent = nullptr);

 private:
  void offer(const QPoint& at);
  void fillForThing(QMenu& menu, base::EntityId id);
  void fillForGround(QMenu& menu);

  Workspace& workspace_;
  WindowActions& actions_;
  Docks& docks_;
};

}  // namespace app
