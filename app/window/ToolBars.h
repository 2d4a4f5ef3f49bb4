#pragma once

#include <QMainWindow>
#include <QToolBar>

#include "app/window/Docks.h"
#include "app/window/WindowActions.h"
#include "app/window/Workspace.h"

namespace app {

/// The one tool bar: file, undo | tools | run | view.
QToolBar* makeToolBar(QMainWindow& window, Workspace& workspace, WindowActions& actions);

/// All commands with their shortcuts. `recent` is filled by whoever knows the files.
struct Menus {
  QMenu* recent = nullptr;
  QMenu* view = nullptr;
};
Menus makeMenus(QMainWindow& window, Workspace& workspace, WindowActions& actions, Docks& docks);

}  // namespace app
