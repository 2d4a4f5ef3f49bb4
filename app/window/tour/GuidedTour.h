#pragma once

#include "app/window/Docks.h"
#include "app/window/WindowActions.h"
#include "app/window/Workspace.h"

namespace app {

/// What the user has done so far, as far as the tour is concerned.
struct TourState {
  bool hasPerson = false;
  bool hasGoal = false;
  bool hasRoute = false;  // a person has a goal
  bool hasRobot = false;
  bool hasRobotGoal = false;
  bool hasRun = false;  // a run has shown its first seconds
  bool isRunning = false;
  bool isPersonTool = false;
  bool isGoalTool = false;
  bool isRouteTool = false;
  bool isRobotTool = false;
  bool isMetricsOpen = false;
  bool hasReadMetric = false;  // the user has selected a metric
};

/// The steps of the tour in order.
enum class TourStep { Person, Goal, Robot, Run, Metric, Done };

/// The first step that is not done. It goes back when the user undoes a step.
TourStep tourStepOf(const TourState& state);

/// What to do next, in one or two sentences.
QString tourText(TourStep step, const TourState& state, const WindowActions& actions,
                 const Workspace& workspace);

/// A card over the map that leads through the first run: place a person, give it a goal, place a
/// robot, run, read a metric. It follows what the user actually does, in any order, and can be
/// closed at any time. The button or panel to use next has a frame.
class GuidedTour : public QWidget {
  Q_OBJECT
 public:
  GuidedTour(QMainWindow& window, Workspace& workspace, const WindowActions& actions,
             const Docks& docks);
  void start();  // call when a new scenario is displayed
  void stop();
  bool isActive() const { return isActive_; }
  TourStep step() const { return step_; }
  QString text() const { return text_->text(); }
  /// The widget with the frame; null: none.
  QWidget* target() const { return target_; }

 Q_SIGNALS:
  void manualRequested(const QString& page);

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  TourState stateNow() const;
  void follow();
  void place();
  QWidget* targetOf(TourStep step, const TourState& state) const;
  QWidget* toolButton(const QString& icon) const;
  QWidget* buttonOf(const QAction& action) const;
  void watchMetrics();

  QMainWindow& window_;
  Workspace& workspace_;
  const WindowActions& actions_;
  const Docks& docks_;
  bool isActive_ = false;
  bool hasRun_ = false;
  bool hasReadMetric_ = false;
  TourStep step_ = TourStep::Person;
  QLabel *count_, *title_, *text_;
  QPushButton *skip_, *more_;
  QWidget* frame_;  // around the target
  QPointer<QWidget> target_;
};

}  // namespace app
