#pragma once

#include "editor/look/Theme.h"
#include "editor/panels/EventsPanel.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/runs/ScrubActions.h"

namespace editor {

/// Actions for reset, step back, play or pause, step, and speed; they reflect the state of the
/// runner.
class PlaybackActions : public QObject {
  Q_OBJECT
 public:
  PlaybackActions(SimulationRunner& runner, const Theme& theme);
  void setTheme(const Theme& theme);

  QAction *const reset, *const stepBack, *const playPause, *const step, *const newest;
  QAction* const branchHere;  // Connected by BranchCommand.
  QList<QAction*> all() const { return {reset, stepBack, playPause, step}; }
  /// A combo box of speeds for a tool bar.
  QComboBox* makeSpeedBox(QWidget* parent);

 private:
  void follow();
  SimulationRunner& runner_;
  Theme theme_;
};

/// "12.4": cut to tenths, as on the clock.
QString tenthsText(double seconds);
/// "0:12.4"
QString clockText(double seconds);

/// Asks before the branches of a run are discarded; true without branches.
bool confirmDiscardOfBranches(const SimulationRunner& runner, QWidget* parent);

/// The timeline of the run: clock, slider, ticks, event marks and notes. Dragging seeks; loop
/// markers can be dragged, or drawn with Shift.
class TimelineBar : public QWidget {
  Q_OBJECT
 public:
  TimelineBar(const ScenarioDocument& document, RunEvents& events, SimulationRunner& runner,
              const Theme& theme);
  void setTheme(const Theme& theme);
  void setCompared(const std::vector<TimelineRun>& runs);
  /// Sets the commands of the context menu, which opens at the pointed time.
  void setMenuActions(const QList<QAction*>& actions) { menuActions_ = actions; }
  double length() const;  // Duration of the whole bar [s].
  double xOf(double time) const;
  double timeAt(double x) const;
  QSize sizeHint() const override { return {400, 44}; }
  /// Overlapping events: the mark with the highest priority, and the number of its events.
  struct Cluster {
    EventMark mark = EventMark::None;
    double first = 0.0, last = 0.0;  // x range [px].
    int count = 0;
  };
  std::vector<Cluster> clusters() const;
  /// The time shown by the clock [s]: also after the end of the run, if compared runs are longer.
  double pointedTime() const { return std::max(shownTime(), afterEnd_); }

 Q_SIGNALS:
  /// A time [s] after the end of the shown run was chosen; it holds until the next shown state.
  void timeAfterEndChosen(double time);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void seekTo(double x);
  void seekTime(double time);
  void seekBy(int steps);
  double comparedEnd() const;
  double newestTime() const { return timeOf(runner_.newestFrame()); }
  double shownTime() const { return timeOf(runner_.shownFrame()); }
  static double timeOf(const FramePtr& frame) { return frame ? frame->time : 0.0; }
  void paintClock(QPainter& painter) const;
  void paintTicks(QPainter& painter) const;
  void paintGroove(QPainter& painter) const;
  void paintDroppedRange(QPainter& painter, double x) const;
  void paintMarks(QPainter& painter) const;
  void paintCompared(QPainter& painter) const;
  void paintNotes(QPainter& painter) const;

  const ScenarioDocument& document_;
  RunEvents& events_;
  SimulationRunner& runner_;
  Theme theme_;
  LoopMarks loop_;
  std::vector<TimelineRun> compared_;
  double afterEnd_ = 0.0;  // [s]; 0: a state of the run is shown.
  QList<QAction*> menuActions_;
  QMenu* menu_ = nullptr;
};

}  // namespace editor
