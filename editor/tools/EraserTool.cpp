#include <algorithm>
#include <cmath>

#include "editor/document/EditCommands.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

constexpr double kStepPx = 4.0;  // between the spots looked at in a sweep

/// Removes what is clicked, or all that a sweep crosses, with one command; routes and sources
/// follow. Areas lie under everything and go by a click only.
class EraserTool : public Tool {
 public:
  using Tool::Tool;

  QString statusText() const override {
    if (pressedOn_) {
      return taken_.size() == 1
                 ? tr("Let go to remove it · Esc keeps it")
                 : tr("Let go to remove %1 things · Esc keeps them").arg(taken_.size());
    }
    return tr("Click what is to go, or sweep over it · Areas go by a click");
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
      if (pressedOn_->kind == EntityKind::Area) {  // it was only the ground of the sweep
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
  std::optional<EntityId> pressedOn_;  // while the button is down; may be none
  Vec2 from_ = Vec2::Zero();           // of the gesture
  Vec2 at_ = Vec2::Zero();             // as far as swept
  bool sweeping_ = false;
};

}  // namespace

void addEraserTool(ToolRegistry& to) {
  to.add<EraserTool>({160, QObject::tr("Eraser"), QStringLiteral("tool-eraser"), Qt::Key_E});
}

}  // namespace editor
