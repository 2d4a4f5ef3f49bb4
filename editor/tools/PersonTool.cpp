#include "editor/canvas/Layers.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/Tool.h"
#include "editor/document/EditCommands.h"
#include "editor/tools/Crowd.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

constexpr EntityId kGhost{EntityKind::Human, -1};

double headingTo(const Vec2& from, const CanvasMouse& mouse) {
  const double heading = base::headingOf(mouse.world - from);
  if (mouse.modifiers.testFlag(Qt::AltModifier)) {
    return heading;
  }
  const double step = base::kPi / (mouse.modifiers.testFlag(Qt::ControlModifier) ? 8.0 : 180.0);
  return snappedAngle(heading, step);
}

/// Press places a person, drag turns it.
class PersonTool : public Tool {
 public:
  using Tool::Tool;

  QString statusText() const override {
    return placing_ ? tr("Drag to where the person looks · Esc drops it")
                    : tr("Press to place a person, drag to turn it");
  }

  void press(const CanvasMouse& mouse) override {
    if (mouse.button != Qt::LeftButton) {
      return;
    }
    from_ = snapToGrid(mouse);
    placing_ = newPerson();
    placing_->key = kGhost;
    placing_->initPose = {from_, heading_};
    placing_->hasInitPose = true;
    preview();
    Q_EMIT statusTextChanged();
  }

  void move(const CanvasMouse& mouse) override {
    if (!placing_ || !isDrag(from_, mouse)) {
      return;
    }
    placing_->initPose.heading = headingTo(from_, mouse);
    preview();
    scene().toolLayer().setArrow(from_, mouse.world);
    scene().toolLayer().setTag(mouse.world, headingText(placing_->initPose.heading));
  }

  void release(const CanvasMouse& mouse) override {
    if (mouse.button != Qt::LeftButton || !placing_) {
      return;
    }
    if (isDrag(from_, mouse)) {
      placing_->initPose.heading = headingTo(from_, mouse);
    }
    sim2d::Human human = *placing_;
    heading_ = human.initPose.heading;
    cancel();
    human.name.clear();
    human.id = -1;
    document().setSelection({pushAdd(document(), std::move(human))});
  }

  void cancel() override {
    placing_.reset();
    clearMarks();
  }

 private:
  void preview() { scene().setPreview({*placing_}); }

  double heading_ = 0.0;  // of the next person: as the last one looks
  std::optional<sim2d::Human> placing_;
  Vec2 from_ = Vec2::Zero();
};

}  // namespace

void addPersonTool(ToolRegistry& to) {
  to.add<PersonTool>({20, QObject::tr("Person"), QStringLiteral("tool-person"), Qt::Key_P});
}

}  // namespace editor
