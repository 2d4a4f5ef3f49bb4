#include "app/window/StatusLine.h"

#include <algorithm>
#include <utility>

#include <QCursor>
#include <QHBoxLayout>
#include <QPainter>
#include <QStatusTipEvent>
#include <QToolButton>

#include "editor/canvas/FrameLayer.h"
#include "editor/look/Form.h"
#include "editor/look/Later.h"
#include "sim2d/trace/Arrival.h"

namespace app {

using editor::Role;
using editor::SimulationRunner;

namespace {

constexpr int kPanelButton = 18;  // high [px]

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

/// When the last robot arrived [s]; runs go on for a second then.
double arrivalIn(const sim2d::Recording& recording) {
  const auto& events = recording.events();
  for (std::size_t i = events.size(); i-- > 0;) {
    const auto& [step, event] = events[i];
    if (event.id < 0 && sim2d::isRobotsArrival(event, event.id)) {
      return double(step) * recording.header()->dt;
    }
  }
  return recording.timeOf(recording.size() - 1);
}

/// ": planner NO_VALID_PATH (208)" of the first goal that was given up.
QString failureIn(const sim2d::RunResult& result) {
  for (const sim2d::RobotResult& robot : result.robots) {
    for (const sim2d::GoalEnd& end : robot.goalEnds) {
      if (!end.result.hasSucceeded) {
        return QStringLiteral(": ") + QString::fromStdString(end.result.reason);
      }
    }
  }
  return {};
}

/// Why the run is over, before what can be done now.
QString endOf(const SimulationRunner& runner) {
  if (!runner.result() || runner.newestFrame() == nullptr) {
    return {};
  }
  if (runner.result()->reason == "arrived") {
    return StatusLine::tr("The robot has arrived, %1 s · ")
        .arg(arrivalIn(*runner.recording()), 0, 'f', 1);
  }
  const QString time = StatusLine::tr("%1 s").arg(runner.newestFrame()->time, 0, 'f', 1);
  if (runner.result()->reason == "duration") {
    return StatusLine::tr("The duration is over, %1 · ").arg(time);
  }
  const auto isWay = [&runner](sim2d::WayEnd end) {
    const auto& robots = runner.result()->robots;
    return std::any_of(robots.begin(), robots.end(),
                       [end](const auto& robot) { return robot.result == end; });
  };
  if (isWay(sim2d::WayEnd::Collision)) {
    return StatusLine::tr("The robot has touched something, %1 · ").arg(time);
  }
  if (isWay(sim2d::WayEnd::NavigationFailed)) {
    return StatusLine::tr("Navigation failed%1, %2 · ").arg(failureIn(*runner.result()), time);
  }
  if (isWay(sim2d::WayEnd::GoalMissed)) {
    return StatusLine::tr("Navigation succeeded away from the goal, %1 · ").arg(time);
  }
  return isWay(sim2d::WayEnd::Stuck) ? StatusLine::tr("The robot is stuck, %1 · ").arg(time)
                                     : QString();
}

/// What the line says of the state, and what can be done.
struct Telling {
  Role color = Role::TextSecondary;
  QString state, hint;
};

Telling lookingBack(const SimulationRunner& runner) {
  if (runner.state() == SimulationRunner::State::Running) {
    return {Role::Past, StatusLine::tr("Playing back"),
            StatusLine::tr("Space pauses · End shows the last step")};
  }
  return {Role::Past, StatusLine::tr("Looking back"),
          runner.isFinished()
              ? StatusLine::tr("Space plays on from here · Ctrl+R edits")
              : StatusLine::tr("Space goes on from now · End returns to the newest step")};
}

/// `runEnd`: what ends the run; may be empty.
Telling tellingOf(const SimulationRunner& runner, const QString& runEnd) {
  if (runner.isRecorded()) {
    return {Role::Past, StatusLine::tr("Recorded run"),
            StatusLine::tr("Space plays and pauses · . and , step · Ctrl+R leaves it")};
  }
  if (runner.isLookingBack()) {
    return lookingBack(runner);
  }
  if (runner.state() == SimulationRunner::State::Running) {
    const QString end =
        runEnd.isEmpty() ? runEnd : editor::capitalized(runEnd) + QStringLiteral(" · ");
    return {Role::Ok, StatusLine::tr("Running"),
            end + StatusLine::tr("Space pauses · Click a person to watch")};
  }
  if (runner.isFinished()) {
    return {Role::WarningMark, StatusLine::tr("Finished"),
            endOf(runner) + StatusLine::tr("Space plays it again · Ctrl+R goes back to editing")};
  }
  const QString where = runner.brokeAt()
                            ? StatusLine::tr("Stopped at %1 · ")
                                  .arg(QString::fromStdString(runner.brokeAt()->at.path))
                            : QString();
  return {Role::WarningMark, StatusLine::tr("Paused"),
          where + StatusLine::tr("Space runs on · . steps · Ctrl+R goes back to editing")};
}

}  // namespace

StatusLine::StatusLine(QStatusBar& bar, Workspace& workspace)
    : QObject(&bar),
      bar_(bar),
      workspace_(workspace),
      dot_(new QLabel),
      state_(new QLabel),
      hint_(new editor::ElidedLabel(nullptr)) {
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
  x_ = addRight(72);
  y_ = addRight(72);
  ground_ = addRight(60);
  zoom_ = addRight(64);
  seed_ = addRight(56);
  speed_ = addRight(88);
  const SimulationRunner& runner = workspace_.runner();
  connect(&workspace_.view(), &editor::MapView::cursorMoved, this, &StatusLine::showPlace);
  connect(&workspace_.view(), &editor::MapView::zoomChanged, this, [this] {
    if (workspace_.view().viewport()->underMouse()) {  // the ground moves, the mouse rests
      showPlaceOfMouse();
    }
    showNumbers();
  });
  connect(&workspace_.document(), &editor::ScenarioDocument::changed, this,
          [this](const editor::Change& change) {
            if (change.what == editor::Change::What::Everything) {  // of another ground
              showPlaceOfMouse();
              editor::later(*this, [this] { showPlaceOfMouse(); });  // once it is fitted in
            }
          });
  connect(&runner, &SimulationRunner::stateChanged, this, &StatusLine::showState);
  connect(&runner, &SimulationRunner::lookingBackChanged, this, &StatusLine::showState);
  connect(&runner, &SimulationRunner::broke, this, &StatusLine::showState);
  connect(&runner, &SimulationRunner::speedMeasured, this, &StatusLine::showNumbers);
  connect(&workspace_.tools(), &editor::ToolManager::statusTextChanged, this,
          &StatusLine::showState);
  connect(&workspace_.scene(), &editor::MapScene::guestChanged, this, &StatusLine::showState);
  connect(&workspace_.document(), &editor::ScenarioDocument::settled, this,
          &StatusLine::showNumbers);
  bar.parentWidget()->installEventFilter(this);
  showState();
}

bool StatusLine::eventFilter(QObject* window, QEvent* event) {
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

/// Before the numbers: where closed panels say how much there is in them.
void StatusLine::addPanels(const QList<QAction*>& toggles) {
  panels_ = new QWidget(&bar_);
  auto* row = editor::arranged(new QHBoxLayout(panels_), {0, 0, 8, 0}, 0);
  for (QAction* toggle : toggles) {
    auto* button = new QToolButton(panels_);
    button->setDefaultAction(toggle);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize({14, 14});
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);  // a key opens each
    button->setFixedHeight(kPanelButton);
    row->addWidget(button);
  }
  constexpr int kBeforeNumbers = 3;  // behind dot, state and hint
  bar_.insertPermanentWidget(kBeforeNumbers, panels_);
}

void StatusLine::setIdle(bool idle) {
  idle_ = idle;
  panels_->setVisible(!idle);
  for (QLabel* label : {x_, y_, ground_, zoom_, seed_}) {
    label->setVisible(!idle);
  }
  showState();
}

/// Whom a run is watched for: the only person or robot that is selected, or somebody from a source.
QString StatusLine::watched() const {
  const editor::MapScene& scene = workspace_.scene();
  const std::vector<editor::EntityId>& selection = workspace_.document().selection();
  const bool isBody = selection.size() == 1 && (selection.front().kind == base::EntityKind::Human ||
                                                selection.front().kind == base::EntityKind::Robot);
  const std::optional<editor::Entity> one =
      isBody ? workspace_.document().entity(selection.front()) : std::nullopt;
  const QString name = scene.guest() ? scene.frameLayer().nameOf(*scene.guest())
                       : one         ? editor::displayName(*one)
                                     : QString();
  return name.isEmpty() ? name : name + tr(" · ");
}

void StatusLine::showState() {
  const auto state = workspace_.runner().state();
  const bool isRun = state != SimulationRunner::State::Editing;
  if (isRun && !std::exchange(isRun_, isRun)) {  // what is edited later is not of this run
    runEnd_ = editor::runEndText(workspace_.document().scenario());
  }
  isRun_ = isRun;
  const editor::Tool* tool = workspace_.tools().current();
  Telling telling{Role::TextSecondary, tr("Editing"),
                  tool != nullptr ? tool->statusText() : QString()};
  if (idle_) {
    telling = {Role::TextSecondary, tr("Ready"), tr("Click a demo to open it · Space runs it")};
  } else if (isRun) {
    telling = tellingOf(workspace_.runner(), runEnd_);
  }
  if (isRun) {
    telling.hint.prepend(watched());
  }
  dot_->setPixmap(dotPixmap(workspace_.theme().color(telling.color)));
  state_->setText(telling.state);
  hint_->setWords(tip_.isEmpty() ? telling.hint : tip_);
  showNumbers();
}

void StatusLine::showPlace(const base::Vec2& world) {
  x_->setText(tr("x %1 m").arg(world.x(), 0, 'f', 2));
  y_->setText(tr("y %1 m").arg(world.y(), 0, 'f', 2));
  const std::shared_ptr<const sim2d::OccupancyGrid> map = workspace_.document().map();
  if (map == nullptr || workspace_.scene().isOpenPlane()) {
    ground_->setText(tr("open"));
    return;
  }
  const sim2d::Cell cell = map->worldToCell(world);
  const bool inside = map->contains(cell);
  ground_->setText(!inside                ? tr("outside")
                   : map->isWall(cell)    ? tr("wall")
                   : map->isUnknown(cell) ? tr("unknown")
                                          : tr("free"));
}

void StatusLine::showPlaceOfMouse() {
  const QWidget& canvas = *workspace_.view().viewport();
  if (canvas.underMouse()) {
    showPlace(workspace_.view().worldAt(canvas.mapFromGlobal(QCursor::pos())));
    return;
  }
  for (QLabel* label : {x_, y_, ground_}) {
    label->clear();
  }
}

void StatusLine::showNumbers() {
  zoom_->setText(tr("%1 px/m").arg(qRound(workspace_.view().pixelsPerMetre())));
  seed_->setText(tr("Seed %1").arg(workspace_.document().scenario().desktop.seed.value_or(1)));
  const bool running = workspace_.runner().state() == SimulationRunner::State::Running;
  speed_->setVisible(running);
  speed_->setText(tr("%1 × real time").arg(workspace_.runner().measuredSpeed(), 0, 'f', 1));
}

}  // namespace app
