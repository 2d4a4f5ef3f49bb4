#include "editor/panels/runs/RunInteraction.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bt/human/ActiveBranch.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/look/Form.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/world/WorldState.h"

namespace editor {

namespace {

/// Maps a key to an arrow key; 0: none.
int arrowOf(int key) {
  constexpr std::pair<int, int> kLetters[] = {{Qt::Key_W, Qt::Key_Up},
                                              {Qt::Key_S, Qt::Key_Down},
                                              {Qt::Key_A, Qt::Key_Left},
                                              {Qt::Key_D, Qt::Key_Right}};
  for (const auto& [letter, arrow] : kLetters) {
    if (key == letter || key == arrow) {
      return arrow;
    }
  }
  return 0;
}

}  // namespace

ManualDriveController::ManualDriveController(const ScenarioDocument& document,
                                             SimulationRunner& runner, MapScene& scene,
                                             QWidget& map)
    : document_(document),
      runner_(runner),
      scene_(scene),
      map_(map),
      toggle_(makeAction(tr("&Drive manually"), Qt::Key_J,
                         tr("Drive the selected robot with the arrow keys or W A S D; it brakes "
                            "without a key. Esc returns control to its planner"),
                         this)) {
  toggle_->setCheckable(true);
  toggle_->setIconText(tr("Drive"));
  map_.installEventFilter(this);
  connect(toggle_, &QAction::toggled, this, &ManualDriveController::take);
  connect(&document_, &ScenarioDocument::selectionChanged, this, &ManualDriveController::follow);
  connect(&runner_, &SimulationRunner::stateChanged, this, &ManualDriveController::follow);
  connect(&runner_, &SimulationRunner::frameShown, this, &ManualDriveController::follow);
  connect(&runner_, &SimulationRunner::finished, this, &ManualDriveController::follow);
  connect(&scene_, &MapScene::pullChanged, this, &ManualDriveController::pull);
  follow();
}

bool ManualDriveController::isLive() const {
  return runner_.state() != SimulationRunner::State::Editing && !runner_.isFinished() &&
         !runner_.isLookingBack() && scene_.isRunMode();
}

std::optional<int> ManualDriveController::candidate() const {
  const std::vector<EntityId>& selection = document_.selection();
  if (!isLive() || selection.size() != 1 || selection.front().kind != EntityKind::Robot) {
    return std::nullopt;
  }
  const FrameLayer& layer = scene_.frameLayer();
  const std::vector<int>& ids = layer.frame()->robots.id;
  const auto found = std::find_if(ids.begin(), ids.end(),
                                  [&](int id) { return layer.entityOf(id) == selection.front(); });
  return found == ids.end() ? std::nullopt : std::optional(*found);
}

void ManualDriveController::follow() {
  scene_.setPullable(isLive());
  const std::optional<int> robot = candidate();
  const bool isOther = steering_ != nullptr && robot != steering_->robot();
  if (toggle_->isChecked() && (!robot || isOther)) {
    toggle_->setChecked(false);
  }
  toggle_->setEnabled(robot.has_value());
  if (!isLive() && runner_.state() == SimulationRunner::State::Editing) {
    steering_.reset();  // The run has ended.
  }
}

/// Returns true if the robot can be steered from now on.
bool ManualDriveController::takeControl(int robot) {
  const EntityId id = scene_.frameLayer().entityOf(robot);
  const std::optional<Entity> entity = document_.entity(id);
  const auto* value = entity ? std::get_if<sim2d::Robot>(&*entity) : nullptr;
  if (value == nullptr || !isLive()) {
    return false;
  }
  if (steering_ == nullptr || steering_->robot() != robot) {
    const sim2d::RobotBody body =
        sim2d::bodyOf(sim2d::resolveRobot(document_.scenario(), *value, robot));
    steering_ = std::make_shared<app::ManualDrive>(robot, body);
    limits_ = body.limits;
    runner_.steer(
        [steering = steering_](const sim2d::Frame& frame) { return steering->inputs(frame); });
  }
  return true;
}

void ManualDriveController::take(bool on) {
  keys_.clear();
  const std::optional<int> robot = candidate();
  if (on && robot && takeControl(*robot)) {
    sendVelocity();
    map_.setFocus();
  } else if (on) {
    toggle_->setChecked(false);
  } else if (steering_ != nullptr) {
    steering_->releaseControl();
  }
}

void ManualDriveController::pull() {
  if (const auto& pull = scene_.pull()) {
    if (takeControl(pull->robot)) {
      steering_->driveTo(pull->to);
    }
  } else if (steering_ != nullptr) {
    toggle_->isChecked() ? sendVelocity() : steering_->releaseControl();
  }
}

/// Sends the velocity of the pressed keys.
void ManualDriveController::sendVelocity() {
  const auto isDown = [this](int key) { return keys_.count(key) > 0 ? 1.0 : 0.0; };
  sim2d::BodyTwist twist;
  twist.linear = isDown(Qt::Key_Up) * limits_.maxVel - isDown(Qt::Key_Down) * limits_.maxReverse;
  twist.angular = (isDown(Qt::Key_Left) - isDown(Qt::Key_Right)) * limits_.maxOmega;
  steering_->drive(twist);
}

bool ManualDriveController::isDriveKey(const QKeyEvent& event) {
  const Qt::KeyboardModifiers others =
      event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
  return others == Qt::NoModifier && arrowOf(event.key()) != 0;
}

bool ManualDriveController::eventFilter(QObject* /*watched*/, QEvent* event) {
  if (!toggle_->isChecked()) {
    return false;
  }
  if (event->type() == QEvent::FocusOut && !keys_.empty()) {
    keys_.clear();  // Another widget receives their release.
    sendVelocity();
  }
  const bool isKey = event->type() == QEvent::ShortcutOverride ||
                     event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
  if (!isKey) {
    return false;
  }
  auto& key = static_cast<QKeyEvent&>(*event);
  if (event->type() == QEvent::KeyPress && key.key() == Qt::Key_Escape) {
    toggle_->setChecked(false);
    return true;
  }
  const bool isUp = event->type() == QEvent::KeyRelease && keys_.count(arrowOf(key.key())) > 0;
  if (!isDriveKey(key) && !isUp) {  // A release counts with any modifier.
    return false;
  }
  event->accept();
  if (event->type() != QEvent::ShortcutOverride && !key.isAutoRepeat()) {
    const int arrow = arrowOf(key.key());
    if (event->type() == QEvent::KeyPress) {
      keys_.insert(arrow);
    } else {
      keys_.erase(arrow);
    }
    sendVelocity();
  }
  return true;
}

PeopleInteraction::PeopleInteraction(SimulationRunner& runner, MapScene& scene, QObject* parent)
    : QObject(parent), runner_(runner), scene_(scene) {
  connect(&scene_, &MapScene::pushed, this, &PeopleInteraction::push);
  connect(&runner_, &SimulationRunner::frameShown, this, [this] { waiting_.clear(); });
}

void PeopleInteraction::addInput(sim2d::InputKind kind, int person, const Vec2& velocity) {
  sim2d::Input input;
  input.kind = kind;
  input.id = person;
  input.velocity = velocity;
  runner_.addInput(std::move(input));
}

void PeopleInteraction::push(int person, const Vec2& velocity) {
  addInput(sim2d::InputKind::Push, person, velocity);
}

void PeopleInteraction::stop(int person) {
  addInput(sim2d::InputKind::Stop, person);
  waiting_[person] = true;
}

void PeopleInteraction::resume(int person) {
  addInput(sim2d::InputKind::Resume, person);
  waiting_[person] = false;
}

bool PeopleInteraction::isStopped(int person) const {
  if (const auto waits = waiting_.find(person); waits != waiting_.end()) {
    return waits->second;
  }
  const FramePtr shown = runner_.shownFrame();
  bool isStopped = false;
  if (runner_.recording() != nullptr && shown != nullptr) {
    for (const auto& [step, input] : runner_.recording()->inputsUntil(shown->step)) {
      if (input.id == person) {
        isStopped = input.kind == sim2d::InputKind::Stop ||
                    (isStopped && input.kind != sim2d::InputKind::Resume);
      }
    }
  }
  return isStopped;
}

void PeopleInteraction::addPerson(const std::string& like, const Vec2& place) {
  sim2d::Input input;
  input.kind = sim2d::InputKind::Add;
  input.name = like;
  input.pose.position = place;
  runner_.addInput(std::move(input));
}

void PeopleInteraction::addSpawnActions(QMenu& menu, std::optional<int> person, const Vec2& place) {
  const auto add = [&](QMenu& to, const QString& text, const std::string& like) {
    QAction* action = to.addAction(text, this, [this, like, place] { addPerson(like, place); });
    action->setToolTip(
        tr("Spawn a person with the same tree and goals here, as an input of the run"));
  };
  if (person) {
    return;  // A person stands there.
  }
  QMenu* people = menu.addMenu(tr("Add a person like"));
  people->setToolTipsVisible(true);
  for (const sim2d::Human& human : scene_.document().scenario().humans) {
    if (human.listed) {
      add(*people, QString::fromStdString(human.name), human.name);
    }
  }
  people->setEnabled(!people->isEmpty());
}

void PeopleInteraction::fillMenu(QMenu& menu, std::optional<int> person, const Vec2& place) {
  menu.setToolTipsVisible(true);
  if (!runner_.isLive()) {
    return;
  }
  if (person && *person >= 0) {
    const QString name = scene_.frameLayer().nameOf(*person);
    QAction* push = menu.addAction(tr("Push %1…\tShift+drag").arg(name), this,
                                   [this, id = *person] { scene_.armPush(id); });
    push->setToolTip(tr("Then drag an arrow: 1 m is 1 m/s"));
    const bool stopped = isStopped(*person);
    QAction* stop = menu.addAction(
        stopped ? tr("Resume %1").arg(name) : tr("Stop %1").arg(name), this,
        [this, stopped, id = *person] { stopped ? resume(id) : PeopleInteraction::stop(id); });
    stop->setToolTip(tr("The person stops and stands still until resumed"));
  }
  addSpawnActions(menu, person, place);
}

namespace {

constexpr double kSpeechMemory = 4.0;  // [s]

QString spoken(const std::string& text) {
  return QStringLiteral("“%1”").arg(QString::fromStdString(text));
}

}  // namespace

RunOverlayUpdater::RunOverlayUpdater(SimulationRunner& runner, const RunEvents& events,
                                     MapView& view)
    : QObject(&view),
      runner_(runner),
      events_(events),
      view_(view),
      reader_(new RunOverlayReader(view.mapScene(), this)) {
  connect(&runner_, &SimulationRunner::frameShown, this, &RunOverlayUpdater::follow);
  connect(&view_.mapScene(), &MapScene::optionsChanged, this, &RunOverlayUpdater::follow);
  connect(&view_.mapScene(), &MapScene::spawnedAgentChanged, this, &RunOverlayUpdater::follow);
  connect(&view_.mapScene().document(), &ScenarioDocument::selectionChanged, this,
          &RunOverlayUpdater::follow);
  view_.viewport()->installEventFilter(this);
  follow();
}

void RunOverlayUpdater::follow() {
  const CanvasOptions& options = view_.mapScene().options();
  runner_.setPlannerDebug(options.localCosts || options.globalCosts || options.masks,
                          options.candidates);
  reader_->show(runner_.recording(), runner_.shownFrame(),
                runner_.state() == SimulationRunner::State::Running);
}

QString RunOverlayUpdater::thoughtOf(int id) const {
  const RecordingPtr recording = runner_.recording();
  const FramePtr frame = runner_.shownFrame();
  if (recording == nullptr || frame == nullptr || id < 0) {
    return {};
  }
  return QString::fromStdString(bt::activeBranchOf(recording->treeAt(id, frame->step)).words());
}

/// Recent speech of an agent, said and heard.
QStringList RunOverlayUpdater::speechOf(int id, double time) const {
  const std::vector<RunEvent>& all = events_.events();
  auto at = std::partition_point(all.begin(), all.end(), [&](const RunEvent& event) {
    return event.time <= time - kSpeechMemory;
  });
  QStringList lines;
  for (; at != all.end() && at->time <= time + 1e-9; ++at) {
    const sim2d::Event& event = at->event;
    if (!event.hasId || event.id != id) {
      continue;
    }
    if (event.kind == sim2d::EventKind::Say) {
      lines << tr("says %1").arg(spoken(event.text));
    } else if (event.kind == sim2d::EventKind::Heard) {
      lines << tr("hears %1: %2")
                   .arg(view_.mapScene().frameLayer().nameOf(event.other), spoken(event.text));
    }
  }
  lines.removeDuplicates();
  return lines;
}

QString RunOverlayUpdater::tooltipFor(int id) const {
  const FramePtr frame = runner_.shownFrame();
  const FrameLayer& layer = view_.mapScene().frameLayer();
  if (frame == nullptr || !layer.positionOf(id)) {
    return {};
  }
  const sim2d::BodyColumns& columns =
      id < 0 ? frame->robots : static_cast<const sim2d::BodyColumns&>(frame->humans);
  const auto found = std::find(columns.id.begin(), columns.id.end(), id);
  if (found == columns.id.end()) {
    return {};
  }
  const auto k = static_cast<std::size_t>(found - columns.id.begin());
  const QString name = layer.nameOf(id);
  QStringList lines = {name.isEmpty() ? tr("Person %1").arg(id) : name};
  if (const QString thought = thoughtOf(id); !thought.isEmpty()) {
    lines << thought;
  }
  lines << speechOf(id, frame->time);
  const double speed = std::hypot(columns.vx[k], columns.vy[k]);
  QString last = QStringLiteral("%1 m/s").arg(speed, 0, 'f', 2);
  if (columns.goal[k] != sim2d::kNoGoal) {
    last += tr(" · to %1").arg(goalName(columns.goal[k]));
  }
  lines << last;
  return lines.join(QLatin1Char('\n'));
}

bool RunOverlayUpdater::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ToolTip || !view_.mapScene().isRunMode()) {
    return QObject::eventFilter(watched, event);
  }
  const auto* help = static_cast<QHelpEvent*>(event);
  const std::optional<int> id = view_.mapScene().frameLayer().agentAt(view_.worldAt(help->pos()));
  const QString words = id ? tooltipFor(*id) : QString();
  if (words.isEmpty()) {
    QToolTip::hideText();
  } else {
    QToolTip::showText(help->globalPos(), words, view_.viewport());
  }
  event->accept();
  return true;
}

}  // namespace editor
