#include "app/window/StatusLine.h"

#include "app/window/Docks.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/Form.h"
#include "sim2d/base/Find.h"
#include "sim2d/trace/Frame.h"

namespace app {

using editor::Role;
using editor::SimulationRunner;

namespace {

constexpr int kPanelButton = 18;  // height [px]
constexpr int kMarkSpace = 18;    // [px], for the icon of the most severe problem

QPixmap dotPixmap(const QColor& color) {
  constexpr int kRatio = 3;
  QPixmap pixmap(10 * kRatio, 10 * kRatio);
  pixmap.setDevicePixelRatio(kRatio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawEllipse(QRectF(1.0, 1.0, 8.0, 8.0));
  return pixmap;
}

/// When the last robot arrived, as the events and the metrics have it: "29.8 s", or "29.8 s, 28.8 s
/// after its start", which is the time to reach the goal. Runs continue for 1 s after it.
QString arrivalIn(const sim2d::Recording& recording) {
  const auto text = [](double seconds) { return StatusLine::tr("%1 s").arg(seconds, 0, 'f', 1); };
  const auto& events = recording.events();
  for (std::size_t i = events.size(); i-- > 0;) {
    const auto& [step, event] = events[i];
    if (event.id < 0 && sim2d::isRobotArrival(event, event.id)) {
      const double time = double(step) * recording.header()->dt;
      const sim2d::TraceRobot* robot = recording.header()->robot(event.id);
      const double start = robot == nullptr ? 0.0 : robot->startTime;
      return start > 0.0
                 ? StatusLine::tr("%1, %2 after its start").arg(text(time), text(time - start))
                 : text(time);
    }
  }
  return text(recording.timeOf(recording.size() - 1));
}

/// The reason of the first aborted goal: ": planner NO_VALID_PATH (208)".
QString failureIn(const sim2d::RunResult& result) {
  for (const sim2d::RobotResult& robot : result.robots) {
    for (const sim2d::GoalResult& end : robot.goalResults) {
      if (!end.result.hasSucceeded) {
        return QStringLiteral(": ") + QString::fromStdString(end.result.reason);
      }
    }
  }
  return {};
}

/// The reason why the run ended, as the first part of the hint.
QString endText(const SimulationRunner& runner) {
  if (!runner.result() || runner.newestFrame() == nullptr) {
    return {};
  }
  if (runner.result()->reason == "arrived") {
    return StatusLine::tr("The robot has arrived, %1 · ").arg(arrivalIn(*runner.recording()));
  }
  const QString time = StatusLine::tr("%1 s").arg(runner.newestFrame()->time, 0, 'f', 1);
  if (runner.result()->reason == "duration") {
    return StatusLine::tr("Time limit reached, %1 · ").arg(time);
  }
  const auto hasResult = [&runner](sim2d::NavigationOutcome end) {
    const auto& robots = runner.result()->robots;
    return std::any_of(robots.begin(), robots.end(),
                       [end](const auto& robot) { return robot.result == end; });
  };
  using Outcome = sim2d::NavigationOutcome;
  const std::pair<Outcome, QString> ends[] = {
      {Outcome::Collision, StatusLine::tr("The robot collided, %1 · ").arg(time)},
      {Outcome::NavigationFailed,
       StatusLine::tr("Navigation failed%1, %2 · ").arg(failureIn(*runner.result()), time)},
      {Outcome::GoalMissed,
       StatusLine::tr("Navigation succeeded, but not at the goal, %1 · ").arg(time)},
      {Outcome::Stuck, StatusLine::tr("The robot is stuck, %1 · ").arg(time)}};
  const auto* end = base::findIf(ends, [&](const auto& each) { return hasResult(each.first); });
  return end == nullptr ? QString() : end->second;
}

/// The width of a button with any count and icon, so that no other button moves. `button` has
/// neither.
int slotWidth(const QToolButton& button, const QAction& toggle) {
  const auto has = [&toggle](const char* property) { return toggle.property(property).toBool(); };
  const int digits = button.fontMetrics().horizontalAdvance(QStringLiteral("  999+"));
  return button.sizeHint().width() + (has(kMarkedProperty) ? kMarkSpace : 0) +
         (has(kCountedProperty) ? digits : 0);
}

/// The end of the path of a node: "…/Fallback/GoTo".
QString shortPath(const QString& path) {
  const QString end = path.section(QLatin1Char('/'), -2);
  return end == path ? path : QStringLiteral("…/") + end;
}

/// The displayed state and hint.
struct StateText {
  Role color = Role::TextSecondary;
  QString state, hint;
  QString reason{};  // why the run stopped; stays visible while a status tip replaces the hint
};

StateText playbackText(const SimulationRunner& runner) {
  if (runner.state() == SimulationRunner::State::Running) {
    return {Role::Past, StatusLine::tr("Playing back"),
            StatusLine::tr("Space pauses · End shows the last step")};
  }
  return {Role::Past, StatusLine::tr("Playback paused"),
          runner.isFinished() ? StatusLine::tr("Space plays from here · Ctrl+R returns to editing")
                              : StatusLine::tr("Space resumes · End returns to the newest step")};
}

/// The state of a run that has ended: whether the robots with goals have reached them.
StateText finishedText(const SimulationRunner& runner) {
  StateText text{Role::WarningMark, StatusLine::tr("Finished"),
                 StatusLine::tr("Space replays · Ctrl+R returns to editing"), endText(runner)};
  int reached = 0;
  int missed = 0;
  if (!runner.result()) {
    return text;
  }
  for (const sim2d::RobotResult& robot : runner.result()->robots) {
    const bool hasReached = robot.result == sim2d::NavigationOutcome::Arrived;
    reached += hasReached ? 1 : 0;
    missed += robot.result && !hasReached ? 1 : 0;
  }
  if (missed > 0) {
    text.color = Role::Error;
    text.state = StatusLine::tr("Goal not reached");
  } else if (reached > 0) {
    text.color = Role::Ok;
    text.state = StatusLine::tr("Goal reached");
  }
  return text;
}

/// `runEnd`: the end condition of the run; may be empty.
StateText stateTextOf(const SimulationRunner& runner, const QString& runEnd) {
  if (runner.isRecorded()) {
    return {Role::Past, StatusLine::tr("Recorded run"),
            StatusLine::tr("Space plays and pauses · . and , step · Ctrl+R closes it")};
  }
  if (runner.isLookingBack()) {
    return playbackText(runner);
  }
  if (runner.state() == SimulationRunner::State::Running) {
    const QString end =
        runEnd.isEmpty() ? runEnd : editor::capitalized(runEnd) + QStringLiteral(" · ");
    return {Role::Ok, StatusLine::tr("Running"),
            end + StatusLine::tr("Space pauses · Click a person for details")};
  }
  if (runner.isFinished()) {
    return finishedText(runner);
  }
  const QString where =
      runner.currentBreak()
          ? StatusLine::tr("Stopped at %1 · ")
                .arg(shortPath(QString::fromStdString(runner.currentBreak()->at.path)))
          : QString();
  return {Role::WarningMark, StatusLine::tr("Paused"),
          StatusLine::tr("Space resumes · . steps · Ctrl+R returns to editing"), where};
}

}  // namespace

StatusLine::StatusLine(QStatusBar& bar, Workspace& workspace)
    : QObject(&bar), bar_(bar), workspace_(workspace) {
  bar_.setSizeGripEnabled(false);
  bar_.setFixedHeight(24);
  bar_.setContentsMargins(8, 0, 4, 0);
  QFont bold = state_->font();
  bold.setWeight(QFont::DemiBold);
  state_->setFont(bold);
  bar_.addWidget(dot_);
  bar_.addWidget(state_);
  hint_->setContentsMargins(8, 0, 0, 0);
  hint_->setForegroundRole(QPalette::PlaceholderText);
  bar_.addWidget(hint_, 1);
  position_ = addRight(136);
  zoom_ = addRight(52);
  seed_ = addRight(48);
  speed_ = addRight(88);
  const SimulationRunner& runner = workspace_.runner();
  connect(&workspace_.view(), &editor::MapView::cursorMoved, this, &StatusLine::showPosition);
  connect(&workspace_.view(), &editor::MapView::zoomChanged, this, [this] {
    if (workspace_.view().viewport()->underMouse()) {  // the map moves under the mouse
      showMousePosition();
    }
    showNumbers();
  });
  connect(&workspace_.document(), &editor::ScenarioDocument::changed, this,
          [this](const editor::Change& change) {
            if (change.what == editor::Change::What::Everything) {  // another map
              showMousePosition();
              editor::later(*this, [this] { showMousePosition(); });  // after fitting the view
            }
          });
  connect(&runner, &SimulationRunner::stateChanged, this, &StatusLine::showState);
  connect(&runner, &SimulationRunner::lookingBackChanged, this, &StatusLine::showState);
  connect(&runner, &SimulationRunner::breakpointHit, this, &StatusLine::showState);
  connect(&runner, &SimulationRunner::speedMeasured, this, &StatusLine::showNumbers);
  connect(&workspace_.tools(), &editor::ToolManager::statusTextChanged, this,
          &StatusLine::showState);
  connect(&workspace_.scene(), &editor::MapScene::spawnedAgentChanged, this,
          &StatusLine::showState);
  connect(&workspace_.document(), &editor::ScenarioDocument::stepFinished, this,
          &StatusLine::showNumbers);
  connect(&workspace_.document(), &editor::ScenarioDocument::runChanged, this,
          &StatusLine::showNumbers);
  bar.parentWidget()->installEventFilter(this);
  workspace_.view().installEventFilter(this);
  showState();
}

bool StatusLine::eventFilter(QObject* window, QEvent* event) {
  if (window == &workspace_.view()) {  // tools need the map
    if (event->type() == QEvent::Show || event->type() == QEvent::Hide) {
      showState();
    }
    return false;
  }
  if (event->type() == QEvent::StatusTip) {
    tip_ = static_cast<QStatusTipEvent*>(event)->tip();
    showState();
    return true;
  }
  return QObject::eventFilter(window, event);
}

QLabel* StatusLine::addRight(int width) {
  QLabel* label = editor::secondaryLabel({});
  label->setMinimumWidth(width);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  label->setContentsMargins(4, 0, 4, 0);
  bar_.addPermanentWidget(label);
  return label;
}

/// Adds buttons for closed panels before the numbers. Those with a count in each session show it.
void StatusLine::addPanels(const QList<QAction*>& toggles) {
  panels_ = new QWidget(&bar_);
  auto* row = editor::configuredLayout(new QHBoxLayout(panels_), {0, 0, 8, 0}, 0);
  for (QAction* toggle : toggles) {
    auto* button = new QToolButton(panels_);
    button->setDefaultAction(toggle);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize({14, 14});
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);  // each has a shortcut
    button->setFixedHeight(kPanelButton);
    row->addWidget(button);
    if (!toggle->property(kCountedProperty).toBool()) {  // its tab has the count: this is for hints
      const auto showTitle = [button, toggle] { button->setText(toggle->text()); };
      connect(toggle, &QAction::changed, button, showTitle);
      showTitle();
    }
    button->setMinimumWidth(slotWidth(*button, *toggle));
  }
  // The speed, which is shown only during a run, takes its space from the hint: the buttons stay.
  constexpr int kBeforeNumbers = 3;  // after dot, state and hint
  bar_.removeWidget(speed_);
  bar_.insertPermanentWidget(kBeforeNumbers, speed_);
  bar_.insertPermanentWidget(kBeforeNumbers + 1, panels_);
  showNumbers();
}

void StatusLine::setIdle(bool idle) {
  idle_ = idle;
  panels_->setVisible(!idle);
  for (QLabel* label : {position_, zoom_, seed_}) {
    label->setVisible(!idle);
  }
  showState();
}

/// The name of the followed body: the only selected person or robot, or a spawned person. Empty:
/// none.
QString StatusLine::watchedName() const {
  const editor::MapScene& scene = workspace_.scene();
  const std::vector<editor::EntityId>& selection = workspace_.document().selection();
  const bool isBody = selection.size() == 1 && (selection.front().kind == base::EntityKind::Human ||
                                                selection.front().kind == base::EntityKind::Robot);
  const std::optional<editor::Entity> one =
      isBody ? workspace_.document().entity(selection.front()) : std::nullopt;
  const QString name = scene.spawnedAgent() ? scene.frameLayer().nameOf(*scene.spawnedAgent())
                       : one                ? editor::displayName(*one)
                                            : QString();
  return name.isEmpty() ? name : name + tr(" · ");
}

void StatusLine::showState() {
  const auto state = workspace_.runner().state();
  const bool isRun = state != SimulationRunner::State::Editing;
  if (isRun && !std::exchange(isRun_, isRun)) {  // later edits do not apply to this run
    runEnd_ = editor::runEndText(workspace_.document().scenario());
  }
  isRun_ = isRun;
  const editor::Tool* tool = workspace_.tools().current();
  const QString use = !workspace_.view().isVisible() ? tr("F8 returns to the map")
                      : tool != nullptr              ? tool->statusText()
                                                     : QString();
  StateText stateText{Role::TextSecondary, tr("Editing"), use};
  if (idle_) {
    stateText = {Role::TextSecondary, tr("Ready"),
                 tr("Click a scenario to open it · Space runs it")};
  } else if (isRun) {
    stateText = stateTextOf(workspace_.runner(), runEnd_);
  }
  const QString watched = isRun ? watchedName() : QString();
  dot_->setPixmap(dotPixmap(workspace_.theme().color(stateText.color)));
  state_->setText(stateText.state);
  hint_->setFullText(tip_.isEmpty() ? stateText.reason + watched + stateText.hint
                                    : stateText.reason + tip_);
  showNumbers();
}

/// "1.25, 3.20 m · free"
void StatusLine::showPosition(const base::Vec2& world) {
  const auto show = [&](const QString& cell) {
    position_->setText(
        tr("%1, %2 m · %3").arg(world.x(), 0, 'f', 2).arg(world.y(), 0, 'f', 2).arg(cell));
  };
  const std::shared_ptr<const sim2d::OccupancyGrid> map = workspace_.document().map();
  if (map == nullptr || workspace_.scene().isOpenPlane()) {
    show(tr("open"));
    return;
  }
  const sim2d::Cell cell = map->worldToCell(world);
  show(!map->contains(cell)   ? tr("outside")
       : map->isWall(cell)    ? tr("wall")
       : map->isUnknown(cell) ? tr("unknown")
                              : tr("free"));
}

void StatusLine::showMousePosition() {
  const QWidget& canvas = *workspace_.view().viewport();
  if (canvas.underMouse()) {
    showPosition(workspace_.view().worldAt(canvas.mapFromGlobal(QCursor::pos())));
  } else {
    position_->clear();
  }
}

void StatusLine::showNumbers() {
  zoom_->setText(tr("%1 px/m").arg(qRound(workspace_.view().pixelsPerMetre())));
  const std::shared_ptr<const sim2d::Scenario>& run = workspace_.runner().scenarios().now;
  const sim2d::Scenario& scenario = run != nullptr ? *run : workspace_.document().scenario();
  seed_->setText(tr("Seed %1").arg(scenario.desktop.seed.value_or(1)));
  const bool running = workspace_.runner().state() == SimulationRunner::State::Running;
  speed_->setVisible(running);
  speed_->setText(tr("%1 × real time").arg(workspace_.runner().measuredSpeed(), 0, 'f', 1));
}

}  // namespace app
