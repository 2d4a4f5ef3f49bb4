#pragma once

#include <QMainWindow>
#include <QToolBar>

#include "app/window/Docks.h"
#include "app/window/WindowActions.h"
#include "app/window/Workspace.h"

namespace app {

/// The one tool bar: file, undo | tools | run | view.
QToolBar* makeToolBar(QMainWindow& window, Workspace& workspace, WindowActions& actions);

/// All commands with their shortcuts. Returns the menu of recent files, for whoever knows them.
QMenu* makeMenus(QMainWindow& window, Workspace& workspace, WindowActions& actions, Docks& docks);

/// The menu of the right mouse button on the map, while the tool to select is at hand: other tools
/// end their lines with that button.
void connectCanvasMenu(Workspace& workspace, const WindowActions& actions, const Docks& docks);

}  // namespace app
