#include "editor/canvas/Layers.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/Snap.h"
#include "editor/document/EditCommands.h"
#include "editor/document/Geometry.h"
#include "editor/tools/SelectTool.h"

// What SelectTool does with handles and corners.
namespace editor {

bool SelectTool::grabHandle(const CanvasMouse& mouse) {
  const auto [id, handle] = scene().handleAt(mouse.world);
  if (handle.kind == Handle::Kind::None) {
    return false;
  }
  gesture_ = Gesture::Handle;
  grabbed_ = id;
  handle_ = handle;
  pulled_.reset();
  return true;
}

void SelectTool::grabRobotGoal(const CanvasMouse& mouse) {
  // Selected just now, it shows its handles: one drag is enough to move its goal.
  const EntityId robot = grabbed_;
  if (grabHandle(mouse) && (grabbed_ != robot || handle_.kind != Handle::Kind::RobotGoal)) {
    gesture_ = Gesture::Pressed;
    grabbed_ = robot;
  }
}

void SelectTool::previewHandle(const CanvasMouse& mouse) {
  const std::optional<Entity> entity = document().entity(grabbed_);
  if (!entity) {
    end();
    return;
  }
  const Vec2 to = handleTarget(*entity, mouse);
  pulled_ = pulled(*entity, handle_, to, mouse.modifiers.testFlag(Qt::AltModifier));
  scene().setPreview({*pulled_});
  scene().toolLayer().setTag(mouse.world, handleText(*entity, to));
}

Vec2 SelectTool::handleTarget(const Entity& entity, const CanvasMouse& mouse) const {
  if (handle_.kind == Handle::Kind::Turn) {
    const Vec2 centre = *positionOf(entity);
    const Vec2 offset = mouse.world - centre;
    return mouse.modifiers.testFlag(Qt::ShiftModifier)
               ? Pose2{centre, snappedAngle(base::headingOf(offset))}.ahead(offset.norm())
               : mouse.world;
  }
  if (handle_.kind == Handle::Kind::Size && kindOf(entity) == EntityKind::Human) {
    return mouse.world;
  }
  SnapWish wish;
  wish.without = {grabbed_};
  const std::vector<Vec2>* corners = cornersOf(entity);
  if (const auto* door = std::get_if<sim2d::Door>(&entity)) {
    wish.anchor = handle_.index == 0 ? door->to : door->from;
  } else if (corners != nullptr && handle_.kind == Handle::Kind::Vertex && corners->size() > 1) {
    const auto index = static_cast<std::size_t>(handle_.index);
    const bool isStart = index == 0 && hasOpenLine(entity);
    wish.anchor = (*corners)[isStart ? 1 : (index + corners->size() - 1) % corners->size()];
  }
  return snap(mouse, wish);
}

QString SelectTool::handleText(const Entity& before, const Vec2& to) const {
  if (handle_.kind == Handle::Kind::Turn) {
    const std::optional<double> heading = headingOf(*pulled_);
    const double turn = base::headingOf(to - *positionOf(before)) - 0.5 * base::kPi;
    return headingText(heading ? *heading : base::wrapToPi(turn));
  }
  const auto* obstacle = std::get_if<sim2d::Obstacle>(&*pulled_);
  if (obstacle != nullptr && obstacle->kind == sim2d::ObstacleKind::Box) {
    return QStringLiteral("%1 × %2 m")
        .arg(obstacle->length, 0, 'f', 2)
        .arg(obstacle->width, 0, 'f', 2);
  }
  if (obstacle != nullptr && obstacle->kind == sim2d::ObstacleKind::Circle) {
    return tr("radius %1 m").arg(obstacle->radius, 0, 'f', 2);
  }
  return placeText(to);
}

void SelectTool::doubleClick(const CanvasMouse& mouse) {
  if (mouse.button != Qt::LeftButton || scene().isRunMode() || document().selection().size() != 1) {
    return;
  }
  std::optional<Entity> value = document().entity(document().selection().front());
  std::vector<Vec2>* corners = value ? cornersOf(*value) : nullptr;
  if (corners == nullptr) {
    return;
  }
  const auto [owner, handle] = scene().handleAt(mouse.world);
  if (handle.kind == Handle::Kind::Vertex) {
    end();
    if (corners->size() > fewestCorners(*value)) {
      corners->erase(corners->begin() + handle.index);
      pushEdit(document(), {*value}, tr("Remove corner"));
    }
    return;
  }
  const double reach = kSnapReachPx / mouse.pixelsPerMetre;
  if (const std::optional<std::size_t> edge = edgeNear(*value, mouse.world, reach)) {
    end();
    const Vec2 place = snap(mouse, {std::nullopt, {idOf(*value)}, {}, true});
    corners->insert(corners->begin() + static_cast<std::ptrdiff_t>(*edge) + 1, place);
    pushEdit(document(), {*value}, tr("Add corner"));
    scene().toolLayer().clear();
  }
}

}  // namespace editor
