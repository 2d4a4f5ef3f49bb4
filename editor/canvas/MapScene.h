#pragma once

#include "editor/document/ScenarioDocument.h"
#include "editor/look/Theme.h"
#include "sim2d/trace/Recording.h"

namespace editor {

class EntityItem;
class FrameLayer;
class FullLayer;
class GroupLayer;
class LabelLayer;
class MapItem;
class RouteLayer;
class RouteModel;
class RunOverlays;
class SelectionLayer;
class SpriteAtlas;
class Tool;
class ToolLayer;
struct CanvasMouse;
struct Label;
struct ToolMarks;

/// Scene coordinates are metres with y down.
inline QPointF toScene(const Vec2& world) {
  return {world.x(), -world.y()};
}
inline QPolygonF toScene(const std::vector<Vec2>& world) {
  QPolygonF points;
  for (const Vec2& point : world) {
    points << toScene(point);
  }
  return points;
}
inline Vec2 toWorld(const QPointF& scene) {
  return {scene.x(), -scene.y()};
}

/// Optional canvas layers, each with its own switch.
struct CanvasOptions {
  bool names = true, routes = true, grid = true, rulers = false;
  bool trails = true, robotPath = true, speech = true, proxemics = false, forces = false;
  bool lidar = true, detections = false, candidates = false;                  // Robots in a run.
  bool localCosts = false, globalCosts = false, masks = false;                // Planners in a run.
  bool velocities = false, gaussian = false, sight = false, density = false;  // People in a run.
  bool plans = false, contacts = false, thoughts = false;                     // People in a run.
  bool map = true, people = true, robots = true, goals = true, obstacles = true, areas = true;
  bool groups = true;                            // People who walk together.
  bool snapToPoints = true, snapToWalls = true;  // Snapping of drawn and moved points.
  bool snapToGrid = false;
  bool guides = true;         // Alignment with other entities while dragging.
  double trailSeconds = 6.0;  // Length of the trails of a run.
  /// Layers with an opacity below 1, named by their switch.
  std::vector<std::pair<bool CanvasOptions::*, double>> opacities = {};

  double opacityOf(bool CanvasOptions::*layer) const {
    for (const auto& [each, opacity] : opacities) {
      if (each == layer) {
        return opacity;
      }
    }
    return 1.0;
  }
  void setOpacity(bool CanvasOptions::*layer, double opacity);
};

/// The opacity of a layer, multiplied into a painter until destroyed.
class LayerOpacity {
 public:
  LayerOpacity(QPainter& painter, const CanvasOptions& options, bool CanvasOptions::*layer)
      : painter_(painter), before_(painter.opacity()) {
    painter_.setOpacity(before_ * (layer != nullptr ? options.opacityOf(layer) : 1.0));
  }
  ~LayerOpacity() { painter_.setOpacity(before_); }
  Q_DISABLE_COPY_MOVE(LayerOpacity)

 private:
  QPainter& painter_;
  double before_;
};

/// The part of the canvas being painted. Moving: previewed (dragged) or simulated entities, tool
/// marks and the selection. Resting: the rest.
enum class CanvasPart { All, Resting, Moving };

/// Draws the document. Items are updated with the document; mouse events go to the current tool.
class MapScene : public QGraphicsScene {
  Q_OBJECT
 public:
  MapScene(ScenarioDocument& document, const Theme& theme, QObject* parent = nullptr);
  ~MapScene() override;
  Q_DISABLE_COPY_MOVE(MapScene)

  const ScenarioDocument& document() const { return document_; }
  const Theme& theme() const { return theme_; }
  void setTheme(const Theme& theme);
  const CanvasOptions& options() const { return options_; }
  void setOptions(const CanvasOptions& options);

  void setTool(Tool* tool);
  Tool* tool() const { return tool_; }

  /// The topmost entity within 6 screen pixels; none if there is none.
  EntityId entityAt(const Vec2& world) const;
  std::vector<EntityId> entitiesIn(const Vec2& corner, const Vec2& opposite) const;
  EntityItem* item(EntityId id) const {
    const auto found = items_.find(id);
    return found == items_.end() ? nullptr : found->second;
  }
  void setHovered(EntityId id);

  /// Shows these values instead of those of the document until cleared. New values (whose key is
  /// not in the document) are shown as ghosts.
  void setPreview(const std::vector<Entity>& values);
  void clearPreview() {
    if (!preview_.empty()) {
      setPreview({});
    }
  }
  /// The value from the preview or the document.
  std::optional<Entity> shown(EntityId id) const {
    const auto found = preview_.find(id);
    return found != preview_.end() ? std::optional<Entity>(found->second) : document_.entity(id);
  }
  /// Shows these entities almost transparent, because they are about to be removed. Each call
  /// replaces the previous list.
  void setFaded(const std::vector<EntityId>& ids);

  double pixelsPerMetre() const { return pixelsPerMetre_; }
  void setPixelsPerMetre(double value);  // Called by the view.
  QRectF contentRect() const;            // Of map and entities, or of map and run area [m].
  /// The area of a recorded run, whose people need not be where the document has them. Empty: none.
  void setRunArea(const QRectF& area);
  bool isOpenPlane() const { return document_.map()->isEmpty(); }  // Free space everywhere.
  QRectF groundRect() const;                        // The map, or the full extent of an open plane.
  const QRectF& extent() const { return extent_; }  // The area that can be panned to.

  /// Run mode: people and robots are drawn from frames; null ends it. `recording` is the recording
  /// of the frame, if there is one: trails then include skipped frames.
  void showFrame(sim2d::FramePtr frame, const sim2d::Recording* recording = nullptr);
  /// Interpolates between the previous and the current frame for smooth motion; 1: current frame.
  void setFrameInterpolation(double share);
  bool isRunMode() const;
  /// An agent of the run that is not in the document, treated as selected.
  std::optional<int> spawnedAgent() const { return spawnedAgent_; }
  void setSpawnedAgent(std::optional<int> agent);
  /// A robot of the run that the mouse pulls to a point.
  struct Pull {
    int robot = 0;
    Vec2 to = Vec2::Zero();
  };
  const std::optional<Pull>& pull() const { return pull_; }
  void setPull(std::optional<Pull> pull);
  /// A person of the run who is about to be pushed: an arrow from the person, one metre per 1 m/s.
  struct Push {
    int person = 0;
    Vec2 velocity = Vec2::Zero();  // [m/s]
  };
  const std::optional<Push>& push() const { return push_; }
  void setPush(std::optional<Push> push) {
    push_ = isPullable_ ? std::move(push) : std::nullopt;
    update();
  }
  /// The next drag, wherever it begins, sets the push of this person; none: disarmed.
  void armPush(std::optional<int> person) { armedPush_ = person; }
  std::optional<int> armedPush() const { return armedPush_; }
  /// A person of the run who is dragged to where a branch would start with them.
  struct Placement {
    int person = 0;
    Pose2 pose;
  };
  const std::optional<Placement>& placement() const { return placement_; }
  void setPlacement(const std::optional<Placement>& placement) {
    placement_ = isPlaceable_ ? placement : std::nullopt;
    update();
  }
  void clearPlacement() { setPlacement({}); }
  bool isPlaceable() const { return isPlaceable_; }  // The run is paused and can be branched.
  void setPlaceable(bool placeable) {
    isPlaceable_ = placeable;
    if (!placeable && placement_) {
      clearPlacement();
    }
  }
  bool isPullable() const { return isPullable_; }  // False: the run has finished, or was recorded.
  void setPullable(bool pullable);
  FrameLayer& frameLayer() const { return *frameLayer_; }
  RunOverlays& overlays() const { return *overlays_; }  // Overlays of the run.
  /// Adds a layer for run data beneath the figures. The scene owns it.
  void addRunLayer(std::unique_ptr<FullLayer> layer);
  const SelectionLayer& selectionLayer() const { return *selectionLayer_; }
  RouteModel& routes() const { return *routes_; }
  ToolMarks& marks();  // Mutable access; schedules a repaint.

  // For views that cache a picture of the resting part
  bool isCrowded() const;                   // Has too many entities for fast painting.
  std::vector<EntityId> movingIds() const;  // Entities in the preview.
  /// Incremented by every change of the appearance of the resting part.
  int restingRevision() const { return restingRevision_; }
  QColor groundColor() const;  // Background colour.
  /// Paints one part; the painter has the transform of a view.
  void paintPart(QPainter& painter, CanvasPart part, const QRectF& exposed);

  // For items and layers
  CanvasPart paintedPart() const { return part_; }
  bool isPainted(EntityId id) const {  // Belongs to the part that is being painted.
    return part_ == CanvasPart::All || (part_ == CanvasPart::Moving) == isMoving(id);
  }
  bool isHovered(EntityId id) const {  // Hovered, and highlighted in this part.
    return id == hovered_ && (part_ != CanvasPart::Resting || hoveredOnTop() != id);
  }
  SpriteAtlas& sprites() const { return *sprites_; }            // Sprites of people at this zoom.
  bool isDoorOpen(EntityId id, const sim2d::Door& door) const;  // In shown frame, else at start.
  double layerOpacity(EntityKind kind) const;                   // Of the layer of this kind.
  double bodyRadius(const Entity& entity) const;                // For people and robots [m].
  bool isSizable(const Entity& entity) const;  // False if a pedestrian model sets the radius.
  /// Minimum radius of a figure [px]; larger for people if there are few.
  double minFigurePx(EntityKind kind) const;
  double figureRadius(const Entity& entity) const;  // Radius as painted [m].
  std::vector<Label> labels() const;
  std::vector<QRectF> labelObstacles()
      const;  // Areas that labels must not cover, scene coordinates.

 Q_SIGNALS:
  void optionsChanged();
  void themeChanged();
  void spawnedAgentChanged();
  void pullChanged();
  void pushed(int person, const base::Vec2& velocity);  // [m/s]
  void placed(int person, const base::Pose2& pose);     // The placement is shown until cleared.

 protected:
  void mousePressEvent(QGraphicsSceneMouseEvent* event) override;
  void mouseMoveEvent(QGraphicsSceneMouseEvent* event) override;
  void mouseReleaseEvent(QGraphicsSceneMouseEvent* event) override;
  void mouseDoubleClickEvent(QGraphicsSceneMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void apply(const Change& change);
  void rebuildAll();
  void sync(EntityId id);
  void syncItems();
  void updateMap();
  void updateExtent();
  void planRoutes();
  void drop(EntityId id);
  bool isShown(EntityId id) const;
  bool isMoving(EntityId id) const;
  void applyOpacities();
  void showGhosts();
  void updateRoutes();
  void invalidateResting() {
    ++restingRevision_;
    update();
  }
  /// The hovered small entity, which is painted over the resting picture so that the picture need
  /// not change.
  EntityId hoveredOnTop() const {
    const bool isSmall = hovered_.kind == EntityKind::Human || hovered_.kind == EntityKind::Robot ||
                         hovered_.kind == EntityKind::Goal;
    return isSmall ? hovered_ : EntityId();
  }
  void dispatchMouse(QGraphicsSceneMouseEvent& event, void (Tool::*handler)(const CanvasMouse&));

  ScenarioDocument& document_;
  Theme theme_;
  CanvasOptions options_;
  Tool* tool_ = nullptr;
  EntityId hovered_;
  std::optional<int> spawnedAgent_;
  std::optional<Pull> pull_;
  std::optional<Placement> placement_;
  bool isPlaceable_ = false, isPullable_ = false;
  double pixelsPerMetre_ = 50.0;
  std::map<EntityId, EntityItem*> items_;
  std::map<EntityId, Entity> preview_;
  std::vector<EntityId> faded_;
  CanvasPart part_ = CanvasPart::All;
  int restingRevision_ = 0;
  std::unique_ptr<SpriteAtlas> sprites_;
  QRectF extent_, knownGround_, runArea_;
  MapItem* mapItem_ = nullptr;
  QGraphicsItem* gridItem_ = nullptr;
  GroupLayer* groupLayer_ = nullptr;
  RouteLayer* routeLayer_ = nullptr;
  FrameLayer* frameLayer_ = nullptr;
  std::unique_ptr<RunOverlays> overlays_;
  QGraphicsItem *groundOverlay_ = nullptr, *topOverlay_ = nullptr;
  SelectionLayer* selectionLayer_ = nullptr;
  std::vector<FullLayer*> runLayers_;  // Added by addRunLayer().
  LabelLayer* labelLayer_ = nullptr;
  ToolLayer* toolLayer_ = nullptr;
  RouteModel* routes_ = nullptr;
  std::optional<Push> push_;
  std::optional<int> armedPush_;
};

}  // namespace editor
