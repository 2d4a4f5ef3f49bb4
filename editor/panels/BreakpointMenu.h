#pragma once

#include <QMenu>

#include "editor/run/SimulationRunner.h"

namespace editor {

/// Fills a menu with what stops a run at a node: `path` as records name it, of this person (id) or
/// of anybody; conditions are asked for in a dialog over `window`.
void fillBreakpointMenu(QMenu& menu, SimulationRunner& runner, const std::string& path, int person,
                        QWidget& window);

/// "when it fails, of anybody, if id > 2"
QString breakpointWords(const sim2d::TreeBreakpoint& point);

}  // namespace editor
