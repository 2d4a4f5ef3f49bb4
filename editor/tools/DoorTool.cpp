#include "editor/tools/DoorTool.h"

namespace editor {

namespace {

constexpr double kNarrowest = 0.2;  // [m]

}  // namespace

std::optional<Entity> DoorTool::spanned(const Vec2& from, const Vec2& to) const {
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

}  // namespace editor
