#include "editor/tools/Drawing.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

constexpr double kNarrowest = 0.2;  // [m]

/// Doors: from the hinge to the other jamb, open at the start.
class DoorTool : public DragDrawing {
 public:
  using DragDrawing::DragDrawing;

  QString statusText() const override {
    return tr("Drag a door from its hinge to the other jamb · Shift: 15° steps");
  }

 protected:
  std::optional<Entity> spanned(const Vec2& from, const Vec2& to) const override {
    if ((to - from).norm() < kNarrowest) {
      return std::nullopt;
    }
    sim2d::Door door;
    door.key = ghostOf(EntityKind::Door);
    door.name = "door";
    door.from = from;
    door.to = to;
    return door;
  }

  QString undoText() const override { return tr("Add door"); }
};

}  // namespace

void addDoorTool(ToolRegistry& to) {
  to.add<DoorTool>({110, QObject::tr("Door"), QStringLiteral("tool-door"), Qt::Key_D});
}

}  // namespace editor
