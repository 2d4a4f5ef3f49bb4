#include "editor/document/EditCommands.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

constexpr EntityId kPreviewId{EntityKind::Goal, -1};

/// A click adds a goal. A click on a goal picks it up and the next click places it; a drag moves
/// it.
class GoalTool : public Tool {
  Q_DECLARE_TR_FUNCTIONS(editor::GoalTool)
 public:
  using Tool::Tool;

  QString statusText() const override {
    if (held_ && held_->key != kPreviewId) {
      return tr("Click to place goal %1 · Esc cancels").arg(held_->id);
    }
    return tr("Click to add a goal · Click or drag a goal to move it");
  }

  void press(const CanvasMouse& mouse) override {
    pressed_ = true;
    from_ = mouse.world;
    justPicked_ = false;
    if (held_) {  // Picked up by the previous click.
      preview(placeOf(mouse));
      return;
    }
    grip_ = Vec2::Zero();
    const sim2d::GlobalGoal* goal = document().goal(scene().entityAt(mouse.world));
    if (goal != nullptr) {
      held_ = *goal;
      grip_ = goal->position - mouse.world;
      justPicked_ = true;
      document().setSelection({goal->key});
    } else {
      held_ = sim2d::GlobalGoal();
      held_->key = kPreviewId;
      held_->id = UniqueNames(document().scenario()).nextGoal();
      preview(placeOf(mouse));
    }
    Q_EMIT statusTextChanged();
  }

  void move(const CanvasMouse& mouse) override {
    if (!held_) {
      scene().setHovered(scene().entityAt(mouse.world));
      return;
    }
    if (!pressed_ || isDrag(from_, mouse)) {
      preview(placeOf(mouse));
    }
  }

  void release(const CanvasMouse& mouse) override {
    const bool wasPressed = std::exchange(pressed_, false);
    const bool isPickedUp = justPicked_ && !isDrag(from_, mouse);  // Follows until next click.
    if (wasPressed && held_ && !isPickedUp) {
      drop(placeOf(mouse));
    }
  }

  void cancel() override {
    held_.reset();
    pressed_ = false;
    scene().setHovered({});
    clearMarks();
  }

 private:
  void preview(const Vec2& at) {
    sim2d::GlobalGoal shown = *held_;
    shown.position = at;
    scene().setPreview({shown});
    marks().tag = {at, placeText(at)};
  }

  void drop(const Vec2& at) {
    sim2d::GlobalGoal goal = *held_;
    cancel();
    goal.position = at;
    if (goal.key == kPreviewId) {
      document().setSelection({pushAdd(document(), goal)});
    } else {
      pushEdit(document(), {goal}, tr("Move goal %1").arg(goal.id));
    }
  }

  Vec2 placeOf(CanvasMouse mouse) const {
    const bool isDragged = !pressed_ || isDrag(from_, mouse);
    mouse.world += grip_;
    Vec2 onGrid = snapToGrid(mouse);
    if (!isDragged) {
      return onGrid;
    }
    const Alignment aligned = align(mouse, {mouse.world, mouse.world}, {held_->key});
    const Vec2 exact = mouse.world + aligned.offset;
    return {aligned.isAligned[0] ? exact.x() : onGrid.x(),
            aligned.isAligned[1] ? exact.y() : onGrid.y()};
  }

  std::optional<sim2d::GlobalGoal> held_;  // Without a key in the document: a new goal.
  Vec2 from_ = Vec2::Zero();
  Vec2 grip_ = Vec2::Zero();  // Offset from the cursor to the tip of the pin.
  bool pressed_ = false;
  bool justPicked_ = false;
};

}  // namespace

void addGoalTool(ToolRegistry& to) {
  to.add<GoalTool>({50, QObject::tr("Goal"), QStringLiteral("tool-goal"), Qt::Key_G});
}

}  // namespace editor
