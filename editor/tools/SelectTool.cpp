#include "editor/canvas/FrameLayer.h"
#include "editor/document/EditCommands.h"
#include "editor/tools/SelectToolTexts.h"
#include "editor/tools/SelectionActions.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

constexpr double kNudge = 0.1, kBigNudge = 1.0, kFineNudge = 0.01;  // [m]
constexpr double kStrongestPush = 4.0;                              // [m/s]
constexpr Qt::KeyboardModifiers kAddModifiers = Qt::ShiftModifier | Qt::ControlModifier;

bool isAdding(const CanvasMouse& mouse) {
  return (mouse.modifiers & kAddModifiers) != 0;
}

/// A click selects, a drag moves, handles rotate and resize, a drag from free ground selects the
/// enclosed entities, arrow keys nudge. During a run it selects, and a drag pulls a robot.
class SelectTool : public Tool {
  Q_DECLARE_TR_FUNCTIONS(editor::SelectTool)
 public:
  using Tool::Tool;

  QString statusText() const override {
    if (scene().isRunMode()) {
      return SelectToolTexts::ofRun(scene());
    }
    return document().selection().empty()
               ? tr("Click to select · Drag over empty space to select several")
               : SelectToolTexts::ofSelection(document());
  }

  QCursor cursor() const override { return cursor_; }
  /// Keeps the selection for the next tool.
  void deactivate() override {
    end();
    scene().setHovered({});
  }

  void press(const CanvasMouse& mouse) override {
    from_ = mouse.world;
    deselectOnRelease_ = false;
    if (scene().isRunMode()) {
      const std::optional<int> agent = scene().frameLayer().agentAt(mouse.world);
      if (beginPush(agent, mouse)) {
        return;
      }
      selectAgent(agent);
      const bool isRobot = agent && *agent < 0;
      pulledRobot_ = isRobot && scene().isPullable() ? agent : std::nullopt;
      placedPerson_ = agent && !isRobot && scene().isPlaceable() ? agent : std::nullopt;
      return;
    }
    grabbed_ = scene().entityAt(mouse.world);
    const bool hasOtherScenario = grabbed_ && !document().isSelected(grabbed_);
    if (!(isAdding(mouse) && hasOtherScenario) && grabHandle(mouse)) {
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
      deselectOnRelease_ = true;  // A click on one of several selects only that one.
    }
    if (!isAdding(mouse) && grabbed_.kind == EntityKind::Robot) {
      grabRobotGoal(mouse);
    }
    Q_EMIT statusTextChanged();
  }

  void move(const CanvasMouse& mouse) override {
    if (pushedPerson_) {
      const bool isArrow = scene().push() || isDrag(from_, mouse);
      scene().setPush(MapScene::Push{*pushedPerson_, isArrow ? pushTo(mouse) : Vec2(Vec2::Zero())});
    } else if (placedPerson_) {
      if (scene().placement() || isDrag(from_, mouse)) {
        dragPerson(mouse);
      }
    } else if (pulledRobot_ && (scene().pull() || isDrag(from_, mouse))) {
      const bool begins = !scene().pull();
      scene().setPull(MapScene::Pull{*pulledRobot_, mouse.world});
      if (begins) {
        Q_EMIT statusTextChanged();
      }
    } else if (gesture_ == Gesture::None) {
      hover(mouse);
    } else if (gesture_ == Gesture::Moving) {
      previewMove(mouse);
    } else if (gesture_ == Gesture::Handle && pulled_) {
      previewHandle(mouse);
    } else if (isDrag(from_, mouse)) {
      beginDrag(mouse);
    }
  }

  void release(const CanvasMouse& mouse) override {
    if (pushedPerson_) {
      const int person = *pushedPerson_;
      const bool isArrow = scene().push() && isDrag(from_, mouse);
      end();
      if (isArrow) {
        Q_EMIT scene().pushed(person, pushTo(mouse));
      }
      Q_EMIT statusTextChanged();
      return;
    }
    if (const auto placement = scene().placement(); placedPerson_ && placement) {
      end();
      scene().setPlacement(placement);  // Shown until the question is answered.
      Q_EMIT scene().placed(placement->person, placement->pose);
      Q_EMIT statusTextChanged();
      return;
    }
    if (gesture_ == Gesture::Handle && pulled_) {
      previewHandle(mouse);
    }
    const Gesture gesture = gesture_;
    const Vec2 delta = gesture == Gesture::Moving ? deltaFor(mouse) : Vec2(Vec2::Zero());
    const std::optional<Entity> result = pulled_;
    end();
    if (gesture == Gesture::Moving) {
      pushMove(document(), document().selection(), delta);
    } else if (gesture == Gesture::Handle && result) {
      pushEdit(document(), {*result}, tr("Change %1").arg(displayName(*result)));
    } else if (gesture == Gesture::Band) {
      selectBand(mouse);
    } else if (gesture == Gesture::Pressed && deselectOnRelease_) {
      document().setSelection({grabbed_});
    }
    Q_EMIT statusTextChanged();
  }

  /// On an edge of a selected outline: adds a corner; on a corner: removes it.
  void doubleClick(const CanvasMouse& mouse) override {
    if (mouse.button != Qt::LeftButton || scene().isRunMode() ||
        document().selection().size() != 1) {
      return;
    }
    std::optional<Entity> value = document().entity(document().selection().front());
    std::vector<Vec2>* corners = value ? cornersOf(*value) : nullptr;
    if (corners == nullptr) {
      return;
    }
    const auto [owner, handle] = scene().selectionLayer().handleAt(mouse.world);
    if (handle.kind == Handle::Kind::Vertex) {
      end();
      if (corners->size() > minimumCorners(*value)) {
        corners->erase(corners->begin() + handle.index);
        pushEdit(document(), {*value}, tr("Remove corner"));
      }
      return;
    }
    const double reach = kSnapReachPx / mouse.pixelsPerMetre;
    if (const std::optional<std::size_t> edge = outlineEdgeAt(*value, mouse.world, reach)) {
      end();
      const Vec2 place = snap(mouse, {std::nullopt, {idOf(*value)}});
      corners->insert(corners->begin() + static_cast<std::ptrdiff_t>(*edge) + 1, place);
      pushEdit(document(), {*value}, tr("Add corner"));
      marks() = {};
    }
  }

  void cancel() override {
    const bool wasIdle = gesture_ == Gesture::None;
    end();
    if (scene().armedPush()) {
      scene().armPush({});
    } else if (wasIdle) {
      selectAgent({});
    }
    scene().setHovered({});
    Q_EMIT statusTextChanged();
  }

  bool keyPress(const QKeyEvent& event) override {
    if (scene().isRunMode() || gesture_ != Gesture::None) {
      return false;
    }
    if (event.matches(QKeySequence::Delete) || event.key() == Qt::Key_Backspace) {
      pushRemove(document(), document().selection());
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

 private:
  enum class Gesture { None, Pressed, Moving, Handle, Band };
  /// Selects an agent of a run. A spawned agent is not in the document, so the document selection
  /// is then empty.
  void selectAgent(std::optional<int> agent) {
    const EntityId known = agent ? scene().frameLayer().entityOf(*agent) : EntityId();
    document().setSelection(known ? std::vector<EntityId>{known} : std::vector<EntityId>());
    scene().setSpawnedAgent(known ? std::nullopt : agent);
  }
  /// One metre of the arrow is 1 m/s.
  Vec2 pushTo(const CanvasMouse& mouse) const {
    const Vec2 drawn = mouse.world - from_;
    return drawn.norm() > kStrongestPush ? Vec2(kStrongestPush * drawn.normalized()) : drawn;
  }
  /// Keeps the heading; the pointer keeps its place on the figure.
  void dragPerson(const CanvasMouse& mouse) {
    for (const ShownBody& body : scene().frameLayer().shownBodies()) {
      if (body.id == *placedPerson_) {
        const bool begins = !scene().placement();
        const Vec2 to = body.pose.position + (mouse.world - from_);
        scene().setPlacement(MapScene::Placement{body.id, {to, body.pose.heading}});
        if (begins) {
          Q_EMIT statusTextChanged();
        }
      }
    }
  }
  /// With Shift from a person, or from anywhere after the menu has armed the push.
  bool beginPush(std::optional<int> agent, const CanvasMouse& mouse) {
    const bool isPerson = agent && *agent >= 0 && mouse.modifiers.testFlag(Qt::ShiftModifier);
    pushedPerson_ = scene().armedPush()                ? scene().armedPush()
                    : isPerson && scene().isPullable() ? agent
                                                       : std::nullopt;
    scene().armPush({});
    return pushedPerson_.has_value();
  }
  void hover(const CanvasMouse& mouse) {
    if (scene().isRunMode()) {
      cursor_ =
          scene().frameLayer().agentAt(mouse.world) ? Qt::PointingHandCursor : Qt::ArrowCursor;
      return;
    }
    const Handle handle = scene().selectionLayer().handleAt(mouse.world).second;
    const EntityId id =
        handle.kind == Handle::Kind::None ? scene().entityAt(mouse.world) : EntityId{};
    scene().setHovered(id);
    cursor_ = handle.kind == Handle::Kind::Turn   ? Qt::PointingHandCursor
              : handle.kind != Handle::Kind::None ? Qt::CrossCursor
              : id                                ? Qt::SizeAllCursor
                                                  : Qt::ArrowCursor;
  }

  void beginDrag(const CanvasMouse& mouse) {
    if (gesture_ == Gesture::Pressed) {
      gesture_ = Gesture::Moving;
      moving_ = guideBoxOfSelection(document());
      deselectOnRelease_ = false;
      previewMove(mouse);
    } else if (gesture_ == Gesture::Handle) {
      previewHandle(mouse);
    } else {
      marks().band = {from_, mouse.world};
    }
  }

  bool grabHandle(const CanvasMouse& mouse) {
    const auto [id, handle] = scene().selectionLayer().handleAt(mouse.world);
    if (handle.kind == Handle::Kind::None) {
      return false;
    }
    gesture_ = Gesture::Handle;
    grabbed_ = id;
    handle_ = handle;
    pulled_.reset();
    return true;
  }

  void grabRobotGoal(const CanvasMouse& mouse) {
    // The handles of a robot selected by this press are visible, so that a single drag can move its
    // goal.
    const EntityId robot = grabbed_;
    if (grabHandle(mouse) && (grabbed_ != robot || handle_.kind != Handle::Kind::RobotGoal)) {
      gesture_ = Gesture::Pressed;
      grabbed_ = robot;
    }
  }

  Vec2 deltaFor(const CanvasMouse& mouse) const {
    const std::optional<Entity> entity = document().entity(grabbed_);
    const std::optional<Vec2> start = entity ? positionOf(*entity) : std::nullopt;
    if (!start) {
      return Vec2::Zero();
    }
    Vec2 delta = mouse.world - from_;
    const std::optional<int> fixedAxis = fixedAxisOf(mouse, delta);
    SnapRequest wish;
    wish.without = document().selection();
    wish.ontoWalls = grabbed_.kind != EntityKind::Goal;  // Goals at walls are unreachable.
    if (fixedAxis) {
      delta(*fixedAxis) = 0.0;
      wish.ontoPoints = false;
    }
    CanvasMouse target = mouse;
    marks().guides = {};
    if (wish.ontoPoints && grabbed_.kind != EntityKind::Robot) {
      for (const Vec2& own : snapPointsOf(*entity)) {  // Corners snap as well as the centre.
        target.world = own + delta;
        if (snapped(scene(), target, wish).isOnPoint) {
          return snap(target, wish) - own;
        }
      }
    }
    wish.ontoPoints = false;
    target.world = *start + delta;
    return alignedDelta(mouse, delta, snap(target, wish) - *start, fixedAxis);
  }

  /// With Shift, entities move along one axis: the other one.
  static std::optional<int> fixedAxisOf(const CanvasMouse& mouse, const Vec2& delta) {
    const bool isShift = mouse.modifiers.testFlag(Qt::ShiftModifier);
    return isShift ? std::optional<int>(std::abs(delta.x()) < std::abs(delta.y()) ? 0 : 1)
                   : std::nullopt;
  }

  /// `free` aligned with other entities; `onGrid` along axes without alignment.
  Vec2 alignedDelta(const CanvasMouse& mouse, const Vec2& free, const Vec2& onGrid,
                    const std::optional<int>& fixedAxis) const {
    if (!moving_) {
      return onGrid;
    }
    const Alignment aligned = align(mouse, movedBy(*moving_, free), document().selection());
    Vec2 delta = onGrid;
    for (const int axis : {0, 1}) {
      if (aligned.isAligned.at(static_cast<std::size_t>(axis)) && axis != fixedAxis) {
        delta(axis) = free(axis) + aligned.offset(axis);
      }
    }
    return rounded(delta);
  }

  void previewMove(const CanvasMouse& mouse) {
    const Vec2 delta = deltaFor(mouse);
    std::vector<Entity> values = valuesOf(document(), document().selection());
    for (Entity& value : values) {
      value = moved(std::move(value), delta);
    }
    scene().setPreview(values);
    if (const std::optional<Entity> value = scene().shown(grabbed_)) {
      marks().tag = {mouse.world, placeText(*positionOf(*value))};
    }
  }

  void previewHandle(const CanvasMouse& mouse) {
    const std::optional<Entity> entity = document().entity(grabbed_);
    if (!entity) {
      end();
      return;
    }
    const Vec2 to = handleTarget(*entity, mouse);
    pulled_ = withHandleMoved(*entity, handle_, to, mouse.modifiers.testFlag(Qt::AltModifier));
    scene().setPreview({*pulled_});
    marks().tag = {mouse.world, handleText(*entity, to)};
  }

  Vec2 handleTarget(const Entity& entity, const CanvasMouse& mouse) const {
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
    SnapRequest wish;
    wish.without = {grabbed_};
    const std::vector<Vec2>* corners = cornersOf(entity);
    if (const auto* door = std::get_if<sim2d::Door>(&entity)) {
      wish.anchor = handle_.index == 0 ? door->to : door->from;
    } else if (corners != nullptr && handle_.kind == Handle::Kind::Vertex && corners->size() > 1) {
      const auto index = static_cast<std::size_t>(handle_.index);
      const bool isStart = index == 0 && isOpenPolyline(entity);
      wish.anchor = (*corners)[isStart ? 1 : (index + corners->size() - 1) % corners->size()];
    }
    const auto* obstacle = std::get_if<sim2d::Obstacle>(&entity);
    const bool isCircle = obstacle != nullptr && obstacle->kind == sim2d::ObstacleKind::Circle;
    return isCircle ? snap(mouse, wish) : snapAligned(mouse, wish);  // Its handle is on no edge.
  }

  QString handleText(const Entity& before, const Vec2& to) const {
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

  void selectBand(const CanvasMouse& mouse) {
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

  void end() {
    gesture_ = Gesture::None;
    pulled_.reset();
    moving_.reset();
    marks() = {};
    pulledRobot_.reset();
    pushedPerson_.reset();
    placedPerson_.reset();
    scene().clearPlacement();
    scene().setPull({});
    scene().setPush({});
    scene().clearPreview();
  }

  bool nudge(const QKeyEvent& event) {
    static const std::map<int, Vec2> kDirections = {{Qt::Key_Left, {-1.0, 0.0}},
                                                    {Qt::Key_Right, {1.0, 0.0}},
                                                    {Qt::Key_Up, {0.0, 1.0}},
                                                    {Qt::Key_Down, {0.0, -1.0}}};
    const auto direction = kDirections.find(event.key());
    if (direction == kDirections.end()) {
      return false;
    }
    const double step = event.modifiers().testFlag(Qt::ShiftModifier) ? kBigNudge
                        : event.modifiers().testFlag(Qt::AltModifier) ? kFineNudge
                                                                      : kNudge;
    pushMove(document(), document().selection(), step * direction->second, Merge::WithPrevious);
    return true;
  }

  Gesture gesture_ = Gesture::None;
  Vec2 from_ = Vec2::Zero();
  EntityId grabbed_;
  Handle handle_;
  std::optional<Entity> pulled_;
  std::optional<Extent> moving_;  // Bounding box of the selection before it is moved.
  Qt::CursorShape cursor_ = Qt::ArrowCursor;
  bool deselectOnRelease_ = false;
  std::optional<int> pulledRobot_;   // The robot pressed in a run, by its id in the frames.
  std::optional<int> placedPerson_;  // The person pressed while paused, by the id in the frames.
  std::optional<int> pushedPerson_;  // The person being pushed, by the id in the frames.
};

}  // namespace

void addSelectTool(ToolRegistry& to) {
  to.add<SelectTool>({10, QObject::tr("Select"), QStringLiteral("tool-select"), Qt::Key_V});
}

}  // namespace editor
