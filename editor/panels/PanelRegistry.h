#pragma once

#include <functional>
#include <vector>

#include <QAction>
#include <QFileInfo>
#include <QWidget>

#include "editor/canvas/MapView.h"
#include "editor/panels/MetricsFeed.h"
#include "editor/panels/RunEvents.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// A run that is compared with the one that is shown, as the timeline draws it.
struct TimelineRun {
  std::size_t style = 0;         // as of ghostStyle
  double end = 0.0;              // [s]
  std::vector<double> contacts;  // [s]
};

/// What panels show and steer, and what they tell each other and the window. GUI thread.
class PanelContext : public QObject {
  Q_OBJECT
 public:
  PanelContext(MapView& canvas, ScenarioDocument& edited, SimulationRunner& run, RunEvents& events,
               MetricsFeed& metrics)
      : view(canvas), document(edited), runner(run), happened(events), feed(metrics) {}
  const Theme& theme() const { return view.mapScene().theme(); }

  MapView& view;
  ScenarioDocument& document;
  SimulationRunner& runner;
  RunEvents& happened;
  MetricsFeed& feed;
  QAction* drive = nullptr;  // by hand, the robot that is selected
  /// Where dialogs for files begin: never among what the program brought.
  std::function<QString()> folder = [this] { return QFileInfo(document.path()).absolutePath(); };

 Q_SIGNALS:
  void themeChanged(const editor::Theme& theme);
  void problemsFound(const base::Diagnostics& problems);  // by an action; for the list of issues
  /// Told behind the title of the panel, and beside its switch with the mark of the worst of them.
  void counted(QWidget* panel, int count, base::Severity worst = base::Severity::Info);
  void fileWanted(const QString& file, int line);  // is to be shown
  /// Of the tree of the person who is selected, as outlineOf() numbers it; -1 = none.
  void nodeChosen(int node, const QObject* by);
  void comparedChanged(const std::vector<editor::TimelineRun>& runs);
  /// To stand beside the canvas, so many times as wide as that; null: nothing.
  void besideWanted(QWidget* view, int columns);
  void goalsWanted();  // for the people who are selected
};

/// Where a panel is found.
struct PanelInfo {
  int order = 0;  // ascending in the menu and in its area
  QString title;  // in lower case also its name for --dock
  Qt::DockWidgetArea area = Qt::RightDockWidgetArea;
  bool isTab = true;   // one of the tabs of its area; else below what is there
  int room = 0;        // height that its area gets when it is first looked at [px]; 0: as it is
  bool isOpen = true;  // at first
};

/// A panel below the canvas that is closed until it is asked for: the map has the room.
PanelInfo closedBelow(int order, const QString& title);

/// The panels that there are, in their order. Each file `panels/<Name>Panel.cpp` adds its own by a
/// function void add<Name>Panel(PanelRegistry&), which CMake finds.
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
