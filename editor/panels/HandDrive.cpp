#include "editor/panels/HandDrive.h"

#include <algorithm>

#include "editor/canvas/FrameLayer.h"
#include "editor/look/Form.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/world/WorldState.h"

namespace editor {

namespace {

/// The arrow that a key stands for; 0: none.
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

HandDrive::HandDrive(const ScenarioDocument& document, SimulationRunner& runner, MapScene& scene,
                     QWidget& map)
    : document_(document),
      runner_(runner),
      scene_(scene),
      map_(map),
      toggle_(new QAction(tr("&Drive by hand"), this)) {
  toggle_->setCheckable(true);
  toggle_->setShortcut(Qt::Key_J);
  toggle_->setIconText(tr("Drive"));
  describe(*toggle_, tr("Arrows or W A S D drive the robot that is selected; without a key it "
                        "brakes. Esc gives it back to its planner"));
  map_.installEventFilter(this);
  connect(toggle_, &QAction::toggled, this, &HandDrive::take);
  connect(&document_, &ScenarioDocument::selectionChanged, this, &HandDrive::follow);
  connect(&runner_, &SimulationRunner::stateChanged, this, &HandDrive::follow);
  connect(&runner_, &SimulationRunner::frameShown, this, &HandDrive::follow);
  connect(&runner_, &SimulationRunner::finished, this, &HandDrive::follow);
  connect(&scene_, &MapScene::pullChanged, this, &HandDrive::pull);
  follow();
}

bool HandDrive::isLive() const {
  return runner_.state() != SimulationRunner::State::Editing && !runner_.isFinished() &&
         !runner_.isLookingBack() && scene_.isRunMode();
}

std::optional<int> HandDrive::candidate() const {
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

void HandDrive::follow() {
  scene_.setPullable(isLive());
  const std::optional<int> robot = candidate();
  const bool isOther = steering_ != nullptr && robot != steering_->robot();
  if (toggle_->isChecked() && (!robot || isOther)) {
    toggle_->setChecked(false);
  }
  toggle_->setEnabled(robot.has_value());
  if (!isLive() && runner_.state() == SimulationRunner::State::Editing) {
    steering_.reset();  // of a run that is over
  }
}

/// Whether the robot can be steered from now on.
bool HandDrive::hold(int robot) {
  const EntityId id = scene_.frameLayer().entityOf(robot);
  const std::optional<Entity> entity = document_.entity(id);
  const auto* value = entity ? std::get_if<sim2d::Robot>(&*entity) : nullptr;
  if (value == nullptr || !isLive()) {
    return false;
  }
  if (steering_ == nullptr || steering_->robot() != robot) {
    const sim2d::RobotBody body =
        sim2d::bodyOf(sim2d::resolveRobot(document_.scenario(), *value, robot));
    steering_ = std::make_shared<app::HandSteering>(robot, body);
    limits_ = body.limits;
    runner_.steer(
        [steering = steering_](const sim2d::Frame& frame) { return steering->inputs(frame); });
  }
  return true;
}

void HandDrive::take(bool on) {
  keys_.clear();
  const std::optional<int> robot = candidate();
  if (on && robot && hold(*robot)) {
    tell();
    map_.setFocus();
  } else if (on) {
    toggle_->setChecked(false);
  } else if (steering_ != nullptr) {
    steering_->letGo();
  }
}

void HandDrive::pull() {
  if (const auto& pull = scene_.pull()) {
    if (hold(pull->robot)) {
      steering_->headFor(pull->to);
    }
  } else if (steering_ != nullptr) {
    toggle_->isChecked() ? tell() : steering_->letGo();
  }
}

/// What the keys say now.
void HandDrive::tell() {
  const auto isDown = [this](int key) { return keys_.count(key) > 0 ? 1.0 : 0.0; };
  sim2d::BodyTwist twist;
  twist.linear = isDown(Qt::Key_Up) * limits_.maxVel - isDown(Qt::Key_Down) * limits_.maxReverse;
  twist.angular = (isDown(Qt::Key_Left) - isDown(Qt::Key_Right)) * limits_.maxOmega;
  steering_->drive(twist);
}

bool HandDrive::isDriveKey(const QKeyEvent& event) {
  const Qt::KeyboardModifiers others =
      event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
  return others == Qt::NoModifier && arrowOf(event.key()) != 0;
}

bool HandDrive::eventFilter(QObject* /*watched*/, QEvent* event) {
  if (!toggle_->isChecked()) {
    return false;
  }
  if (event->type() == QEvent::FocusOut && !keys_.empty()) {
    keys_.clear();  // their release goes to somebody else
    tell();
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
  if (!isDriveKey(key) && !isUp) {  // up, whatever modifier has come meanwhile
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
    tell();
  }
  return true;
}

}  // namespace editor
