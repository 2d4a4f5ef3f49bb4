#pragma once

#include "app/window/Workspace.h"
#include "app/window/help/Commands.h"

namespace app {

/// The explanation that *What's this?* shows for a widget: its own, or that of the nearest
/// ancestor, as rich text. A widget without one is explained by its tooltip. Empty: none.
QString explanationOf(const QWidget& widget);

/// The explanation with a link to a manual page ("manual:window").
QString withManualLink(const QString& explanation, const QString& page);
constexpr const char* kManualScheme = "manual:";

/// Sets the explanations of all tools, commands, panels and of the map.
void explainWindow(QMainWindow& window, Workspace& workspace);

}  // namespace app
