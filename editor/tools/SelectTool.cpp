#include "editor/tools/SelectTool.h"

#include <algorithm>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/Layers.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/Snap.h"
#include "editor/document/EditCommands.h"
#include "editor/document/Geometry.h"
#include "editor/tools/SelectionActions.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

constexpr double kNudge = 0.1, kBigNudge = 1.0, kFineNudge = 0.01;  // [m]
constexpr Qt::KeyboardModifiers kAddModifiers = Qt::ShiftModifier | Qt::ControlModifier;

bool isAdding(const CanvasMouse& mouse) {
  return (mouse.modifiers & kAddModifiers) != 0;
}

bool hasHandle(const Entity& entity, Handle::Kind kind) {
  const std::vector<Handle> handles = handlesOf(entity, {});
  return std::any_of(handles.begin(), handles.end(),
                     [kind](const Handle& handle) { return handle.kind == kind; });
}

}  // namespace

QString SelectTool::statusText() const {
  if (scene().isRunMode()) {
    return tr("Click a person to look closer · Space pauses");
  }
  if (document().selection().empty()) {
    return tr("Click to select · Drag over empty ground to select several");
  }
  const std::optional<Entity> value = document().entity(document().selection().front());
  const bool isOnly = document().selection().size() == 1 && value;
  QStringList parts{tr("Drag to move")};
  if (isOnly && hasHandle(*value, Handle::Kind::Turn)) {
    parts << tr("Drag the round handle to turn");
  } else if (isOnly && hasHandle(*value, Handle::Kind::Size)) {
    parts << tr("Drag a corner to size");
  }
  if (isOnly && cornersOf(*value) != nullptr) {
    parts << tr("Double click an edge for a new corner");
  } else {
    parts << tr("Ctrl+D duplicates") << tr("Del removes");
  }
  return parts.join(QString::fromUtf8(" · "));
}

void SelectTool::press(const CanvasMouse& mouse) {
  if (mouse.button != Qt::LeftButton) {
    return;
  }
  from_ = mouse.world;
  deselectOnRelease_ = false;
  if (scene().isRunMode()) {
    pressInRun(mouse);
    return;
  }
  grabbed_ = scene().entityAt(mouse.world);
  const bool isOfAnother = grabbed_ && !document().isSelected(grabbed_);
  if (!(isAdding(mouse) && isOfAnother) && grabHandle(mouse)) {
    return;
  }
  if (!grabbed_) {
    gesture_ = Gesture::Band;
    return;
  }
  gesture_ = Gesture::Pressed;
  if (isAdding(mouse)) {
    document().toggleSelected(grabbed_);
  } else if (!document().isSelected(grabbed_)) {
    document().setSelection({grabbed_});
  } else {
    deselectOnRelease_ = true;  // a click on one of several leaves only that one
  }
  if (!isAdding(mouse) && grabbed_.kind == EntityKind::Robot) {
    grabRobotGoal(mouse);
  }
  Q_EMIT statusTextChanged();
}

void SelectTool::pressInRun(const CanvasMouse& mouse) {
  const std::optional<EntityId> hit = scene().agentEntityAt(mouse.world);
  document().setSelection(hit ? std::vector<EntityId>{*hit} : std::vector<EntityId>{});
}

void SelectTool::move(const CanvasMouse& mouse) {
  switch (gesture_) {
    case Gesture::None:
      hover(mouse);
      break;
    case Gesture::Pressed:
      if (isDrag(from_, mouse)) {
        gesture_ = Gesture::Moving;
        deselectOnRelease_ = false;
        previewMove(mouse);
      }
      break;
    case Gesture::Moving:
      previewMove(mouse);
      break;
    case Gesture::Handle:
      if (pulled_ || isDrag(from_, mouse)) {
        previewHandle(mouse);
      }
      break;
    case Gesture::Band:
      if (isDrag(from_, mouse)) {
        scene().toolLayer().setRubberBand(from_, mouse.world);
      }
      break;
  }
}

void SelectTool::hover(const CanvasMouse& mouse) {
  if (scene().isRunMode()) {
    setCursor(scene().agentEntityAt(mouse.world) ? Qt::PointingHandCursor : Qt::ArrowCursor);
    return;
  }
  const Handle handle = scene().handleAt(mouse.world).second;
  const EntityId id =
      handle.kind == Handle::Kind::None ? scene().entityAt(mouse.world) : EntityId{};
  scene().setHovered(id);
  setCursor(handle.kind == Handle::Kind::Turn   ? Qt::PointingHandCursor
            : handle.kind != Handle::Kind::None ? Qt::CrossCursor
            : id                                ? Qt::SizeAllCursor
                                                : Qt::ArrowCursor);
}

void SelectTool::setCursor(Qt::CursorShape shape) {
  if (cursor_ != shape) {
    cursor_ = shape;
    Q_EMIT cursorChanged();
  }
}

Vec2 SelectTool::deltaFor(const CanvasMouse& mouse) const {
  const std::optional<Entity> entity = document().entity(grabbed_);
  const std::optional<Vec2> start = entity ? positionOf(*entity) : std::nullopt;
  if (!start) {
    return Vec2::Zero();
  }
  Vec2 delta = mouse.world - from_;
  SnapWish wish;
  wish.without = document().selection();
  wish.ontoWalls = grabbed_.kind != EntityKind::Goal;  // nobody can reach one there
  if (mouse.modifiers.testFlag(Qt::ShiftModifier)) {   // along one axis
    (std::abs(delta.x()) < std::abs(delta.y()) ? delta.x() : delta.y()) = 0.0;
    wish.ontoPoints = false;
  }
  CanvasMouse target = mouse;
  if (wish.ontoPoints && grabbed_.kind != EntityKind::Robot) {
    for (const Vec2& own : snapPointsOf(*entity)) {  // a corner may hold as well as the middle
      target.world = own + delta;
      if (snapped(scene(), target, wish).isOnPoint) {
        return snap(target, wish) - own;
      }
    }
  }
  wish.ontoPoints = false;
  target.world = *start + delta;
  return snap(target, wish) - *start;
}

void SelectTool::previewMove(const CanvasMouse& mouse) {
  const Vec2 delta = deltaFor(mouse);
  std::vector<Entity> values;
  for (const EntityId id : document().selection()) {
    if (const std::optional<Entity> value = document().entity(id)) {
      values.push_back(moved(*value, delta));
    }
  }
  scene().setPreview(values);
  if (const std::optional<Entity> value = scene().shown(grabbed_)) {
    scene().toolLayer().setTag(mouse.world, placeText(*positionOf(*value)));
  }
}

void SelectTool::selectBand(const CanvasMouse& mouse) {
  std::vector<EntityId> ids = isAdding(mouse) ? document().selection() : std::vector<EntityId>{};
  if (isDrag(from_, mouse)) {
    for (const EntityId id : scene().entitiesIn(from_, mouse.world)) {
      if (std::find(ids.begin(), ids.end(), id) == ids.end()) {
        ids.push_back(id);
      }
    }
  }
  document().setSelection(std::move(ids));
}

void SelectTool::release(const CanvasMouse& mouse) {
  if (mouse.button != Qt::LeftButton) {
    return;
  }
  if (gesture_ == Gesture::Handle && pulled_) {
    previewHandle(mouse);
  }
  const Gesture gesture = gesture_;
  const Vec2 delta = gesture == Gesture::Moving ? deltaFor(mouse) : Vec2(Vec2::Zero());
  const std::optional<Entity> result = pulled_;
  end();
  switch (gesture) {
    case Gesture::Moving:
      pushMove(document(), document().selection(), delta);
      break;
    case Gesture::Handle:
      if (result) {
        pushEdit(document(), {*result}, tr("Change %1").arg(editor::displayName(*result)));
      }
      break;
    case Gesture::Band:
      selectBand(mouse);
      break;
    case Gesture::Pressed:
      if (deselectOnRelease_) {
        document().setSelection({grabbed_});
      }
      break;
    case Gesture::None:
      break;
  }
  Q_EMIT statusTextChanged();
}

void SelectTool::end() {
  gesture_ = Gesture::None;
  pulled_.reset();
  scene().toolLayer().clear();
  scene().clearPreview();
}

void SelectTool::deactivate() {
  end();
  scene().setHovered({});
}

void SelectTool::cancel() {
  const bool wasIdle = gesture_ == Gesture::None;
  end();
  if (wasIdle) {
    document().setSelection({});
  }
  scene().setHovered({});
  Q_EMIT statusTextChanged();
}

bool SelectTool::nudge(const QKeyEvent& event) {
  Vec2 direction = Vec2::Zero();
  switch (event.key()) {
    case Qt::Key_Left:
      direction = {-1.0, 0.0};
      break;
    case Qt::Key_Right:
      direction = {1.0, 0.0};
      break;
    case Qt::Key_Up:
      direction = {0.0, 1.0};
      break;
    case Qt::Key_Down:
      direction = {0.0, -1.0};
      break;
    default:
      return false;
  }
  const double step = event.modifiers().testFlag(Qt::ShiftModifier) ? kBigNudge
                      : event.modifiers().testFlag(Qt::AltModifier) ? kFineNudge
                                                                    : kNudge;
  pushMove(document(), document().selection(), step * direction, Merge::WithPrevious);
  return true;
}

bool SelectTool::keyPress(const QKeyEvent& event) {
  if (scene().isRunMode() || gesture_ != Gesture::None) {
    return false;
  }
  if (event.matches(QKeySequence::Delete) || event.key() == Qt::Key_Backspace) {
    removeSelection(document());
  } else if (event.matches(QKeySequence::SelectAll)) {
    selectAll(document());
  } else if (event.key() == Qt::Key_BracketLeft || event.key() == Qt::Key_BracketRight) {
    rotateSelection(document(), event.key() == Qt::Key_BracketLeft ? kSnapAngle : -kSnapAngle);
  } else if (event.key() == Qt::Key_D && event.modifiers() == Qt::ControlModifier) {
    duplicateSelection(document());
  } else {
    return nudge(event);
  }
  return true;
}

void addSelectTool(ToolRegistry& to) {
  to.add<SelectTool>({10, QObject::tr("Select"), QStringLiteral("tool-select"), Qt::Key_V});
}

}  // namespace editor
