#include <cmath>

#include "editor/document/EditCommands.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

constexpr double kStepPx = 4.0;  // Distance between the sampled points of a drag.

/// Removes the clicked entity, or all entities crossed by a drag, with one command; routes and
/// sources are updated. Areas are removed by a click only, because they lie beneath everything.
class EraserTool : public Tool {
  Q_DECLARE_TR_FUNCTIONS(editor::EraserTool)
 public:
  using Tool::Tool;

  QString statusText() const override {
    if (pressedOn_) {
      return taken_.size() == 1 ? tr("Release to remove it · Esc cancels")
                                : tr("Release to remove %1 items · Esc cancels").arg(taken_.size());
    }
    return tr("Click items to remove them, or drag over them · Click areas to remove them");
  }

  void pressOther(Qt::MouseButton) override { cancel(); }
  void press(const CanvasMouse& mouse) override {
    from_ = at_ = mouse.world;
    sweeping_ = false;
    pressedOn_ = scene().entityAt(mouse.world);
    scene().setHovered({});
    take(*pressedOn_);
  }

  void move(const CanvasMouse& mouse) override {
    if (!pressedOn_) {
      scene().setHovered(scene().entityAt(mouse.world));
      return;
    }
    if (!sweeping_ && isDrag(from_, mouse)) {
      sweeping_ = true;
      if (pressedOn_->kind == EntityKind::Area) {  // The area was only the start of the drag.
        taken_.clear();
        scene().setFaded({});
      }
    }
    if (sweeping_) {
      sweepTo(mouse.world);
    }
  }

  void release(const CanvasMouse&) override {
    const std::vector<EntityId> ids = taken_;
    if (pressedOn_) {
      cancel();
      pushRemove(document(), ids);
    }
  }

  void cancel() override {
    taken_.clear();
    pressedOn_.reset();
    sweeping_ = false;
    scene().setFaded({});
    scene().setHovered({});
    Q_EMIT statusTextChanged();
  }

 private:
  void sweepTo(const Vec2& world) {
    const Vec2 way = world - at_;
    const int steps =
        std::max(1, static_cast<int>(std::ceil(way.norm() * scene().pixelsPerMetre() / kStepPx)));
    for (int i = 1; i <= steps; ++i) {
      const EntityId id = scene().entityAt(at_ + way * (double(i) / steps));
      if (id.kind != EntityKind::Area) {
        take(id);
      }
    }
    at_ = world;
  }

  void take(EntityId id) {
    if (id && std::find(taken_.begin(), taken_.end(), id) == taken_.end()) {
      taken_.push_back(id);
      scene().setFaded(taken_);
      Q_EMIT statusTextChanged();
    }
  }

  std::vector<EntityId> taken_;
  std::optional<EntityId> pressedOn_;  // Set while the button is pressed; may be none.
  Vec2 from_ = Vec2::Zero();           // Start of the gesture.
  Vec2 at_ = Vec2::Zero();             // End of the processed part.
  bool sweeping_ = false;
};

}  // namespace

void addEraserTool(ToolRegistry& to) {
  to.add<EraserTool>({160, QObject::tr("Eraser"), QStringLiteral("tool-eraser"), Qt::Key_E});
}

}  // namespace editor
