#include "editor/panels/runs/RunInteraction.h"

#include <algorithm>
#include <utility>

#include "editor/canvas/FrameLayer.h"
#include "editor/look/Form.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/world/WorldState.h"

namespace editor {

namespace {

/// Maps a key to an arrow key; 0: none.
int arrowOf(int key) {
  switch (key) {
    case Qt::Key_W:
      return Qt::Key_Up;
    case Qt::Key_S:
      return Qt::Key_Down;
    case Qt::Key_A:
      return Qt::Key_Left;
    case Qt::Key_D:
      return Qt::Key_Right;
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Left:
    case Qt::Key_Right:
      return key;
    default:
      return 0;
  }
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

void PeopleInteraction::push(int person, const Vec2& velocity) {
  sim2d::Input input;
  input.kind = sim2d::InputKind::Push;
  input.id = person;
  input.velocity = velocity;
  runner_.addInput(std::move(input));
}

void PeopleInteraction::addInput(sim2d::InputKind kind, int person) {
  sim2d::Input input;
  input.kind = kind;
  input.id = person;
  runner_.addInput(std::move(input));
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
  bool isStopped = false;
  const FramePtr shown = runner_.shownFrame();
  if (runner_.recording() == nullptr || shown == nullptr) {
    return false;
  }
  for (const auto& [step, input] : runner_.recording()->inputsUntil(shown->step)) {
    if (input.id == person && input.kind == sim2d::InputKind::Stop) {
      isStopped = true;
    } else if (input.id == person && input.kind == sim2d::InputKind::Resume) {
      isStopped = false;
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
    stop->setToolTip(tr("The person brakes and stays until resumed"));
  }
  addSpawnActions(menu, person, place);
}

}  // namespace editor
