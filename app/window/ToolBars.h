#pragma once

#include <QtWidgets>

#include "app/window/Docks.h"
#include "app/window/WindowActions.h"
#include "app/window/Workspace.h"

namespace app {

/// The tool bar: file, undo | tools | run | view.
QToolBar* makeToolBar(QMainWindow& window, Workspace& workspace, WindowActions& actions);

/// Creates the menus with all commands. Returns the menu for recent files, which the caller fills.
QMenu* makeMenus(QMainWindow& window, Workspace& workspace, WindowActions& actions, Docks& docks);

/// The context menu of the map while the select tool is active; other tools end their lines with
/// the right button.
void connectCanvasMenu(Workspace& workspace, const WindowActions& actions, const Docks& docks);

}  // namespace app
