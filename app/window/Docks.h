#pragma once

#include <map>
#include <vector>

#include <QDockWidget>
#include <QMainWindow>
#include <QToolBar>

#include "app/window/Workspace.h"

namespace editor {
class BehaviorPanel;
class EventsPanel;
class IssuesPanel;
class MetricsChoicePanel;
class MetricsDock;
class PropertyPanel;
class ScenarioPanel;
class TimelineBar;
}  // namespace editor

namespace app {

class DockTitle;

/// The panels around the canvas: left Scenario, right Properties and Behaviour, below Issues,
/// Metrics and Events as tabs between them, and the timeline over the whole width.
class Docks : public QObject {
  Q_OBJECT
 public:
  Docks(QMainWindow& window, Workspace& workspace);

  /// A further panel: a tab beside those of its area, or below them. `name` is how View and --dock
  /// call it, in lower case.
  QDockWidget* add(Qt::DockWidgetArea area, const QString& title, QWidget* panel, bool tabbed);
  QDockWidget* dock(const QString& name) const;  // any case; null when there is none
  QStringList names() const;                     // lower case, in order of the menu
  const std::vector<QDockWidget*>& all() const { return docks_; }
  void show(const QStringList& names);  // exactly these
  void resetLayout();
  void placeFirst();  // sizes, once the window has its own
  void setTheme(const editor::Theme& theme);
  void setShown(bool shown);  // all of them, for the start page and the full screen
  QWidget* timeline() const;

  editor::ScenarioPanel& scenario() const { return *scenario_; }
  editor::PropertyPanel& properties() const { return *properties_; }
  editor::BehaviorPanel& behavior() const { return *behavior_; }
  editor::IssuesPanel& issues() const { return *issues_; }
  editor::MetricsDock& metrics() const { return *metrics_; }
  editor::EventsPanel& events() const { return *events_; }

 private:
  void showCount(QDockWidget* dock, const QString& title, int count);
  void grow();

  QMainWindow& window_;
  Workspace& workspace_;
  std::vector<QDockWidget*> docks_;
  std::vector<DockTitle*> headings_;          // of these, which own them
  std::map<QDockWidget*, bool> shownBefore_;  // while all are hidden
  QByteArray layoutBefore_;                   // with their sizes, once the window is seen
  editor::ScenarioPanel* scenario_;
  editor::MetricsChoicePanel* choice_;
  editor::PropertyPanel* properties_;
  editor::BehaviorPanel* behavior_;
  editor::IssuesPanel* issues_;
  editor::MetricsDock* metrics_;
  editor::EventsPanel* events_;
  editor::TimelineBar* timeline_;
  QToolBar* timelineBar_;
  bool grown_ = false;
};

}  // namespace app
