#pragma once

#include <vector>

#include <QtWidgets>

namespace app {

/// A page of the manual; `name` is the stem of its file.
struct ManualPage {
  const char* name;
  const char* title;
};

/// All pages in reading order.
const std::vector<ManualPage>& manualPages();

/// The page for a widget, usually the one with the focus: the first of the widget and its ancestors
/// that has the property `editor::kManualPageProperty`, or whose class is in the table of this
/// file. Without one, and for null, "index".
QString manualPageOf(const QWidget* widget);

/// The page for a tool of the canvas, by the name of its icon ("tool-robot").
QString manualPageOfTool(const QString& icon);

/// The folders of the manual; empty: not there.
struct ManualFolders {
  QString html;      // pages built by the build, <name>.html
  QString markdown;  // sources, <name>.md
};
ManualFolders installedManual();

}  // namespace app
