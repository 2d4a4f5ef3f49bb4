#include "app/window/tour/GuidedTour.h"

#include "editor/look/Form.h"
#include "editor/panels/MetricsDock.h"
#include "editor/panels/MetricsTable.h"

namespace app {

using editor::Role;
using editor::SimulationRunner;

namespace {

constexpr int kTourWidth = 340;
constexpr int kMapGap = 16;          // [px] to the corner of the map
constexpr double kRunSeconds = 2.0;  // simulated time after which the run counts
constexpr int kTourSteps = 5;
constexpr int kFrameGap = 2;  // [px] around the target

/// A frame that lets the mouse through.
class TargetFrame : public QWidget {
 public:
  TargetFrame(const editor::Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setObjectName(QStringLiteral("tour-frame"));
    hide();
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme_.color(Role::Accent), 2.0));
    painter.setBrush(theme_.color(Role::Accent, 0.10));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 6.0, 6.0);
  }

 private:
  const editor::Theme& theme_;  // of the workspace
};

QString shortcutOf(const QAction* action) {
  return action == nullptr ? QString() : action->shortcut().toString(QKeySequence::NativeText);
}

QAction* toolAction(const Workspace& workspace, const QString& icon) {
  for (const editor::ToolManager::Entry& tool :
       const_cast<Workspace&>(workspace).tools().entries()) {
    if (tool.info.icon == icon) {
      return tool.action;
    }
  }
  return nullptr;
}

QString titleOf(TourStep step) {
  switch (step) {
    case TourStep::Person:
      return GuidedTour::tr("Place a person");
    case TourStep::Goal:
      return GuidedTour::tr("Give the person a goal");
    case TourStep::Robot:
      return GuidedTour::tr("Place a robot");
    case TourStep::Run:
      return GuidedTour::tr("Run the simulation");
    case TourStep::Metric:
      return GuidedTour::tr("Read a metric");
    case TourStep::Done:
      break;
  }
  return GuidedTour::tr("You have run your first scenario");
}

QString goalText(const TourState& state, const Workspace& workspace) {
  if (!state.hasGoal) {
    return state.isGoalTool
               ? GuidedTour::tr("Click on the map where the person should walk to.")
               : GuidedTour::tr("Press %1 or click the goal tool.")
                     .arg(shortcutOf(toolAction(workspace, QStringLiteral("tool-goal"))));
  }
  return state.isRouteTool
             ? GuidedTour::tr("Click the person, then the goal, then press Enter.")
             : GuidedTour::tr(
                   "The goal is placed; now assign it. Press %1 for the route tool, click the "
                   "person, then the goal, then press Enter.")
                   .arg(shortcutOf(toolAction(workspace, QStringLiteral("tool-route"))));
}

QString robotText(const TourState& state, const Workspace& workspace) {
  if (state.isRobotTool) {
    return state.hasRobot ? GuidedTour::tr("Click on the map where the robot should drive to.")
                          : GuidedTour::tr("Click on the map where the robot should start.");
  }
  return (state.hasRobot
              ? GuidedTour::tr("The robot needs a goal. Press %1 for the robot tool, click where "
                               "it should start, then where it should drive to.")
              : GuidedTour::tr("Press %1 or click the robot tool."))
      .arg(shortcutOf(toolAction(workspace, QStringLiteral("tool-robot"))));
}

}  // namespace

TourStep tourStepOf(const TourState& state) {
  return !state.hasPerson       ? TourStep::Person
         : !state.hasRoute      ? TourStep::Goal
         : !state.hasRobotGoal  ? TourStep::Robot
         : !state.hasRun        ? TourStep::Run
         : !state.hasReadMetric ? TourStep::Metric
                                : TourStep::Done;
}

QString tourText(TourStep step, const TourState& state, const WindowActions& actions,
                 const Workspace& workspace) {
  switch (step) {
    case TourStep::Person:
      return state.isPersonTool
                 ? GuidedTour::tr("Click on the map where the person should start.")
                 : GuidedTour::tr("Press %1 or click the person tool.")
                       .arg(shortcutOf(toolAction(workspace, QStringLiteral("tool-person"))));
    case TourStep::Goal:
      return goalText(state, workspace);
    case TourStep::Robot:
      return robotText(state, workspace);
    case TourStep::Run:
      return state.isRunning ? GuidedTour::tr("Person and robot move to their goals …")
                             : GuidedTour::tr("Press Space, or Play in the tool bar.");
    case TourStep::Metric:
      return state.isMetricsOpen
                 ? GuidedTour::tr(
                       "Click a metric with a value, such as Path length, to plot it "
                       "over time.")
                 : GuidedTour::tr("Click Metrics in the status bar at the bottom.");
    case TourStep::Done:
      break;
  }
  return GuidedTour::tr("Ctrl+R returns to editing, %1 finds every command, F1 opens the manual.")
      .arg(shortcutOf(actions.palette));
}

GuidedTour::GuidedTour(QMainWindow& window, Workspace& workspace, const WindowActions& actions,
                       const Docks& docks)
    : QWidget(&workspace.view()),
      window_(window),
      workspace_(workspace),
      actions_(actions),
      docks_(docks),
      count_(editor::secondaryLabel({}, this)),
      title_(editor::headingLabel({}, workspace.theme().font(12.0, QFont::DemiBold), this)),
      text_(new QLabel(this)),
      skip_(new QPushButton(this)),
      more_(new QPushButton(tr("First scenario in the manual"), this)),
      frame_(new TargetFrame(workspace.theme(), &window)) {
  setObjectName(QStringLiteral("tour"));
  setAccessibleName(tr("Guided tour"));
  setCursor(Qt::ArrowCursor);
  setFixedWidth(kTourWidth);
  text_->setWordWrap(true);
  text_->setMinimumHeight(3 * text_->fontMetrics().lineSpacing());  // the card keeps its size
  text_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  skip_->setFocusPolicy(Qt::TabFocus);
  more_->setFocusPolicy(Qt::TabFocus);
  auto* rows =
      editor::configuredLayout(new QVBoxLayout(this), {16, 12, 16, 12}, 6, {count_, title_, text_});
  auto* buttons = editor::configuredLayout(new QHBoxLayout, {}, 8, {more_});
  buttons->addStretch(1);
  buttons->addWidget(skip_);
  rows->addLayout(buttons);
  hide();
  connect(skip_, &QPushButton::clicked, this, &GuidedTour::stop);
  connect(more_, &QPushButton::clicked, this,
          [this] { Q_EMIT manualRequested(QStringLiteral("first-scenario")); });
  const editor::ScenarioDocument* document = &workspace_.document();
  const SimulationRunner* runner = &workspace_.runner();
  connect(document, &editor::ScenarioDocument::pathChanged, this, &GuidedTour::follow);
  connect(document, &editor::ScenarioDocument::stepFinished, this, &GuidedTour::follow);
  connect(runner, &SimulationRunner::stateChanged, this, &GuidedTour::follow);
  connect(runner, &SimulationRunner::frameShown, this, &GuidedTour::follow);
  connect(&workspace_.tools(), &editor::ToolManager::currentChanged, this, &GuidedTour::follow);
  connect(docks_.dock(QStringLiteral("metrics")), &QDockWidget::visibilityChanged, this,
          &GuidedTour::follow);
  watchMetrics();
  workspace_.view().installEventFilter(this);
  window_.installEventFilter(this);
}

/// A click on a metric or a cursor key counts; the selection that the panel makes itself does not.
void GuidedTour::watchMetrics() {
  const editor::MetricsTable* table = &docks_.panel<editor::MetricsDock>().table();
  const QTreeWidget* tree = &table->tree();
  const auto read = [this, table] {
    const bool isMetric = !table->currentKey().empty();  // else the heading of a group
    hasReadMetric_ = hasReadMetric_ || (isActive_ && isMetric && step_ == TourStep::Metric);
    follow();
  };
  connect(tree, &QAbstractItemView::clicked, this, read);
  connect(tree, &QTreeWidget::currentItemChanged, this, [tree, read] {
    if (tree->hasFocus()) {
      read();
    }
  });
}

void GuidedTour::start() {
  isActive_ = true;
  hasRun_ = false;
  hasReadMetric_ = false;
  follow();
}

void GuidedTour::stop() {
  isActive_ = false;
  if (isAncestorOf(QApplication::focusWidget())) {
    workspace_.view().setFocus();
  }
  hide();
  frame_->hide();
  target_ = nullptr;
}

TourState GuidedTour::stateNow() const {
  const sim2d::Scenario& scenario = workspace_.document().scenario();
  const auto& people = scenario.humans;
  const auto isTool = [this](const char* icon) {
    const QAction* action = toolAction(workspace_, QString::fromLatin1(icon));
    return action != nullptr && action->isChecked();
  };
  TourState state;
  state.hasPerson = !people.empty();
  state.hasGoal = !scenario.goals.empty();
  state.hasRoute = std::any_of(people.begin(), people.end(),
                               [](const sim2d::Human& human) { return !human.goals.empty(); });
  const auto& robots = scenario.robots;
  state.hasRobot = !robots.empty();
  state.hasRobotGoal = std::any_of(robots.begin(), robots.end(), [](const sim2d::Robot& robot) {
    return robot.goal.point.has_value() || !robot.goal.goals.empty();
  });
  state.hasRun = hasRun_;
  state.isRunning = workspace_.runner().state() == SimulationRunner::State::Running;
  state.isPersonTool = isTool("tool-person");
  state.isGoalTool = isTool("tool-goal");
  state.isRouteTool = isTool("tool-route");
  state.isRobotTool = isTool("tool-robot");
  state.isMetricsOpen = docks_.panel<editor::MetricsDock>().isVisible();
  state.hasReadMetric = hasReadMetric_;
  return state;
}

void GuidedTour::follow() {
  if (!isActive_) {
    return;
  }
  const editor::FramePtr frame = workspace_.runner().shownFrame();
  hasRun_ = hasRun_ || (frame != nullptr && frame->time >= kRunSeconds) ||
            workspace_.runner().isFinished();
  const TourState state = stateNow();
  step_ = tourStepOf(state);
  const bool isDone = step_ == TourStep::Done;
  count_->setText(isDone ? tr("Tour finished")
                         : tr("Step %1 of %2").arg(static_cast<int>(step_) + 1).arg(kTourSteps));
  title_->setText(titleOf(step_));
  text_->setText(tourText(step_, state, actions_, workspace_));
  skip_->setText(isDone ? tr("Close") : tr("Skip tour"));
  skip_->setToolTip(isDone ? tr("Close the tour") : tr("End the tour; the scenario stays open"));
  more_->setVisible(isDone);
  more_->setToolTip(tr("Open the manual"));
  target_ = targetOf(step_, state);
  show();
  raise();
  place();
}

QWidget* GuidedTour::buttonOf(const QAction& action) const {
  for (QWidget* place : action.associatedWidgets()) {
    auto* bar = qobject_cast<QToolBar*>(place);
    QWidget* button = bar != nullptr ? bar->widgetForAction(const_cast<QAction*>(&action))
                                     : qobject_cast<QToolButton*>(place);
    if (button != nullptr && button->isVisible()) {
      return button;
    }
  }
  return nullptr;
}

QWidget* GuidedTour::toolButton(const QString& icon) const {
  const QAction* action = toolAction(workspace_, icon);
  return action == nullptr ? nullptr : buttonOf(*action);
}

QWidget* GuidedTour::targetOf(TourStep step, const TourState& state) const {
  switch (step) {
    case TourStep::Person:
      return state.isPersonTool ? nullptr : toolButton(QStringLiteral("tool-person"));
    case TourStep::Goal:
      if (!state.hasGoal) {
        return state.isGoalTool ? nullptr : toolButton(QStringLiteral("tool-goal"));
      }
      return state.isRouteTool ? nullptr : toolButton(QStringLiteral("tool-route"));
    case TourStep::Robot:
      return state.isRobotTool ? nullptr : toolButton(QStringLiteral("tool-robot"));
    case TourStep::Run:
      return state.isRunning ? nullptr : buttonOf(*workspace_.playback().playPause);
    case TourStep::Metric:
      return state.isMetricsOpen
                 ? static_cast<QWidget*>(&docks_.panel<editor::MetricsDock>().table().tree())
                 : buttonOf(*docks_.toggleOf(*docks_.dock(QStringLiteral("metrics"))));
    case TourStep::Done:
      break;
  }
  return nullptr;
}

/// Lower left corner of the map, where neither the options of a tool nor a new person is.
void GuidedTour::place() {
  adjustSize();
  const QWidget& view = workspace_.view();
  move(kMapGap, std::max(kMapGap, view.height() - height() - 3 * kMapGap));
  const bool isShown =
      target_ != nullptr && target_->isVisible() && target_->window() == &window_ && isVisible();
  frame_->setVisible(isShown);
  if (isShown) {
    const QRect there(target_->mapTo(&window_, QPoint()), target_->size());
    frame_->setGeometry(there.adjusted(-kFrameGap, -kFrameGap, kFrameGap, kFrameGap));
    frame_->raise();
  }
}

bool GuidedTour::eventFilter(QObject* watched, QEvent* event) {
  if (isActive_ && (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)) {
    place();
  }
  if (isActive_ && watched == &workspace_.view() && event->type() == QEvent::Hide) {
    frame_->hide();
  }
  return QWidget::eventFilter(watched, event);
}

void GuidedTour::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const editor::Theme& theme = workspace_.theme();
  painter.setPen(QPen(theme.color(Role::Accent), 1.5));
  painter.setBrush(theme.color(Role::Panel));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 8.0, 8.0);
}

}  // namespace app
