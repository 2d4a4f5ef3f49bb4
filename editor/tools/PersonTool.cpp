#include "editor/tools/PersonTool.h"

#include <cmath>

#include "editor/canvas/Layers.h"
#include "editor/canvas/MapScene.h"
#include "editor/document/EditCommands.h"

namespace editor {

namespace {

constexpr EntityId kGhost{EntityKind::Human, -1};

double headingTo(const Vec2& from, const CanvasMouse& mouse) {
  const double heading = base::headingOf(mouse.world - from);
  if (mouse.modifiers.testFlag(Qt::AltModifier)) {
    return heading;
  }
  const double step = base::kPi / (mouse.modifiers.testFlag(Qt::ControlModifier) ? 8.0 : 180.0);
  return base::wrapToPi(std::round(heading / step) * step + 0.0);  // 0, not -0
}

}  // namespace

sim2d::Human newPerson() {
  sim2d::Human human;
  human.groupId = -1;
  human.skin = 0;
  human.maxVel = 1.3;
  human.radius = 0.35;
  human.goalRadius = 0.3;
  human.cyclicGoals = true;
  human.behavior.type = sim2d::BehaviorType::Regular;
  human.behavior.configuration = sim2d::Configuration::Default;
  human.behavior.goalForceFactor = 2.0;
  human.behavior.obstacleForceFactor = 10.0;
  human.behavior.socialForceFactor = 5.0;
  human.behavior.otherForceFactor = 20.0;
  return human;
}

PersonTool::PersonTool(ScenarioDocument& document, MapScene& scene, QObject* parent)
    : Tool(document, scene, parent), prototype_(newPerson()) {}

QString PersonTool::statusText() const {
  return placing_ ? tr("Drag to where the person looks · Esc drops it")
                  : tr("Press to place a person, drag to turn it");
}

void PersonTool::press(const CanvasMouse& mouse) {
  if (mouse.button != Qt::LeftButton) {
    return;
  }
  from_ = snapToGrid(mouse);
  placing_ = prototype_;
  placing_->key = kGhost;
  placing_->initPose.position = from_;
  placing_->hasInitPose = true;
  preview();
  Q_EMIT statusTextChanged();
}

void PersonTool::move(const CanvasMouse& mouse) {
  if (!placing_ || !isDrag(from_, mouse)) {
    return;
  }
  placing_->initPose.heading = headingTo(from_, mouse);
  preview();
  scene().toolLayer().setArrow(from_, mouse.world);
  scene().toolLayer().setTag(mouse.world, headingText(placing_->initPose.heading));
}

void PersonTool::release(const CanvasMouse& mouse) {
  if (mouse.button != Qt::LeftButton || !placing_) {
    return;
  }
  if (isDrag(from_, mouse)) {
    placing_->initPose.heading = headingTo(from_, mouse);
  }
  sim2d::Human human = *placing_;
  prototype_.initPose.heading = human.initPose.heading;
  cancel();
  human.name.clear();
  human.id = -1;
  document().setSelection({pushAdd(document(), std::move(human))});
}

void PersonTool::preview() {
  scene().setPreview({*placing_});
}

void PersonTool::cancel() {
  placing_.reset();
  scene().clearPreview();
  scene().toolLayer().clear();
  Q_EMIT statusTextChanged();
}

}  // namespace editor
