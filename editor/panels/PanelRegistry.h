#pragma once

#include <functional>
#include <vector>

#include <QtWidgets>

#include "editor/canvas/MapView.h"
#include "editor/panels/EventsPanel.h"
#include "editor/panels/MetricsFeed.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// A run compared with the shown run, as drawn on the timeline.
struct TimelineRun {
  std::size_t style = 0;         // As in ghostStyle().
  double end = 0.0;              // [s]
  std::vector<double> contacts;  // [s]
};

/// The objects that panels show and control, and the signals between panels and window. GUI thread.
class PanelContext : public QObject {
  Q_OBJECT
 public:
  PanelContext(MapView& canvas, ScenarioDocument& edited, SimulationRunner& run, RunEvents& events,
               MetricsFeed& metrics)
      : view(canvas), document(edited), runner(run), runEvents(events), feed(metrics) {}
  const Theme& theme() const { return view.mapScene().theme(); }

  MapView& view;
  ScenarioDocument& document;
  SimulationRunner& runner;
  RunEvents& runEvents;
  MetricsFeed& feed;
  QAction* drive = nullptr;  // Drives the selected robot manually.
  /// Initial folder of file dialogs; never among the program's own files.
  std::function<QString()> folder = [this] { return QFileInfo(document.path()).absolutePath(); };

 Q_SIGNALS:
  void themeChanged(const editor::Theme& theme);
  void problemsFound(const base::Diagnostics& problems);  // By an action; for the problem list.
  /// Shows a count in the title of the panel, and beside its switch with the icon of the most
  /// severe problem.
  void counted(QWidget* panel, int count, base::Severity worst = base::Severity::Info);
  void fileRequested(const QString& file, int line);  // Requests showing a file.
  /// A node of the selected person's tree, numbered as in outlineOf(); -1 = none.
  void nodeChosen(int node, const QObject* by);
  void comparedChanged(const std::vector<editor::TimelineRun>& runs);
  /// Requests showing a widget beside the canvas, `columns` times as wide as the canvas; null:
  /// none.
  void sideViewRequested(QWidget* view, int columns);
  void goalsRequested();  // For the selected people.
};

/// The place of a panel in the window.
struct PanelInfo {
  int order = 0;  // Ascending in the menu and in its area.
  QString title;  // In lower case also the name for --dock.
  Qt::DockWidgetArea area = Qt::RightDockWidgetArea;
  bool isTab = true;      // A tab of its area; otherwise below the existing panels.
  int initialHeight = 0;  // Height of its area when first shown [px]; 0: unchanged.
  bool isOpen = true;     // Initially.
};

/// A panel below the canvas that is closed by default to leave space for the map.
PanelInfo closedBottomPanel(int order, const QString& title);

/// The panels in order. Each file `panels/<Name>Panel.cpp` registers its panel in a function void
/// add<Name>Panel(PanelRegistry&), which CMake finds.
class PanelRegistry {
 public:
  using Make = std::function<QWidget*(PanelContext&)>;
  struct Entry {
    PanelInfo info;
    Make make;
  };

  void add(PanelInfo info, Make make);
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

/// All panels of this folder.
PanelRegistry standardPanels();

}  // namespace editor
