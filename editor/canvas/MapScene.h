#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QGraphicsScene>

#include "editor/document/Geometry.h"
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

/// Which extras are drawn; all can be switched one by one.
struct CanvasOptions {
  bool names = true, routes = true, grid = true, rulers = false;
  bool trails = true, robotPath = true, speech = true, proxemics = false, forces = false;
  bool lidar = true, detections = false, candidates = false;                  // of robots, in a run
  bool localCosts = false, globalCosts = false;                               // idem, of planners
  bool velocities = false, gaussian = false, sight = false, density = false;  // of people, in a run
  bool plans = false, contacts = false, thoughts = false;                     // idem
  bool map = true, people = true, robots = true, goals = true, obstacles = true, areas = true;
  bool groups = true;                            // who walks together
  bool snapToPoints = true, snapToWalls = true;  // what is drawn or moved
  bool snapToGrid = false;
  double trailSeconds = 6.0;  // of the trails of a run
};

/// Which part of the canvas is being painted: what is previewed (dragged) or walks in a run, with
/// the marks of tools and selection, or all the rest.
enum class CanvasPart { All, Resting, Moving };

/// Draws the document: items follow its changes; the mouse goes to the current tool.
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
  EntityItem* item(EntityId id) const;
  void setHovered(EntityId id);

  /// Shows these values instead of the document's until cleared; new ones (without a key in the
  /// document) are shown as ghosts.
  void setPreview(const std::vector<Entity>& values);
  void clearPreview();
  std::optional<Entity> shown(EntityId id) const;  // preview or document
  /// Shows these hardly at all: they are about to go. Each call replaces the last.
  void setFaded(const std::vector<EntityId>& ids);

  double pixelsPerMetre() const { return pixelsPerMetre_; }
  void setPixelsPerMetre(double value);                            // by the view
  QRectF contentRect() const;                                      // map and entities [m]
  bool isOpenPlane() const { return document_.map()->isEmpty(); }  // free ground everywhere
  QRectF groundRect() const;                        // the map, or all of an open plane
  const QRectF& extent() const { return extent_; }  // all that can be panned to

  /// Run mode: people and robots are drawn from frames; an empty pointer ends it.
  /// With the recording that it is of, if there is one: trails go through frames passed over.
  void showFrame(std::shared_ptr<const sim2d::Frame> frame,
                 const sim2d::Recording* recording = nullptr);
  /// Between the frame shown before and this one, for a smooth picture; 1: as it is.
  void setFrameShare(double share);
  bool isRunMode() const;
  /// Somebody of the run whom the document does not know, looked at as if selected.
  std::optional<int> guest() const { return guest_; }
  void setGuest(std::optional<int> agent);
  /// A robot of the run that the mouse pulls to a point.
  struct Pull {
    int robot = 0;
    Vec2 to = Vec2::Zero();
  };
  const std::optional<Pull>& pull() const { return pull_; }
  void setPull(std::optional<Pull> pull);
  /// A person of the run who is about to get a push: an arrow from where they are, one metre of it
  /// is one metre per second.
  struct Push {
    int person = 0;
    Vec2 velocity = Vec2::Zero();  // [m/s]
  };
  const std::optional<Push>& push() const { return push_; }
  void setPush(std::optional<Push> push);
  /// The next drag draws the arrow of this person, wherever it begins; none: of nobody.
  void armPush(std::optional<int> person) { armedPush_ = person; }
  std::optional<int> armedPush() const { return armedPush_; }
  bool isPullable() const { return isPullable_; }  // false: the run is over, or was recorded
  void setPullable(bool pullable);
  FrameLayer& frameLayer() const { return *frameLayer_; }
  RunOverlays& overlays() const { return *overlays_; }  // of the run
  /// What others draw of a run, beneath its figures. The scene owns it.
  void addRunLayer(std::unique_ptr<FullLayer> layer);
  const SelectionLayer& selectionLayer() const { return *selectionLayer_; }
  RouteModel& routes() const { return *routes_; }
  ToolMarks& marks();  // to be changed: they are painted anew

  // for views that keep a picture of what rests
  bool isCrowded() const;                   // so many things that painting them all takes its time
  std::vector<EntityId> movingIds() const;  // what is previewed
  /// Counts whatever changes the look of what rests.
  int restingRevision() const { return restingRevision_; }
  QColor groundColor() const;  // beneath everything
  /// Paints one part; the painter's transform is that of a view.
  void paintPart(QPainter& painter, CanvasPart part, const QRectF& exposed);

  // for items and layers
  CanvasPart paintedPart() const { return part_; }
  bool isPainted(EntityId id) const;                  // belongs to the part that is being painted
  bool isHovered(EntityId id) const;                  // and is to be painted so in this part
  SpriteAtlas& sprites() const { return *sprites_; }  // of people, at this zoom
  bool isDoorOpen(EntityId id, const sim2d::Door& door) const;  // in the frame shown, else at start
  double bodyRadius(const Entity& entity) const;                // people and robots [m]
  bool isSizable(const Entity& entity) const;  // not a person whose model has its own radius
  /// Of the smallest figures [px]: people are larger where there are few, they catch the eye.
  double leastFigurePx(EntityKind kind) const;
  double figureRadius(const Entity& entity) const;  // as it is painted [m]
  std::vector<Label> labels() const;
  std::vector<QRectF> solidParts() const;  // what labels keep off, scene

 Q_SIGNALS:
  void optionsChanged();
  void themeChanged();
  void guestChanged();
  void pullChanged();
  void pushed(int person, const base::Vec2& velocity);  // [m/s]

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
  void takeMap();
  void updateExtent();
  void planRoutes();
  void drop(EntityId id);
  bool isShown(EntityId id) const;
  bool isMoving(EntityId id) const;
  void takeRoutes();
  void noteChange();
  EntityId onTop() const;
  void give(QGraphicsSceneMouseEvent& event, void (Tool::*hear)(const CanvasMouse&));

  ScenarioDocument& document_;
  Theme theme_;
  CanvasOptions options_;
  Tool* tool_ = nullptr;
  EntityId hovered_;
  std::optional<int> guest_;
  std::optional<Pull> pull_;
  bool isPullable_ = false;
  double pixelsPerMetre_ = 50.0;
  std::map<EntityId, EntityItem*> items_;
  std::map<EntityId, Entity> preview_;
  std::vector<EntityId> faded_;
  CanvasPart part_ = CanvasPart::All;
  int restingRevision_ = 0;
  std::unique_ptr<SpriteAtlas> sprites_;
  QRectF extent_, knownGround_;
  MapItem* mapItem_ = nullptr;
  GroupLayer* groupLayer_ = nullptr;
  RouteLayer* routeLayer_ = nullptr;
  FrameLayer* frameLayer_ = nullptr;
  std::unique_ptr<RunOverlays> overlays_;
  QGraphicsItem *groundOverlay_ = nullptr, *topOverlay_ = nullptr;
  SelectionLayer* selectionLayer_ = nullptr;
  std::vector<FullLayer*> runLayers_;  // of others
  LabelLayer* labelLayer_ = nullptr;
  ToolLayer* toolLayer_ = nullptr;
  RouteModel* routes_ = nullptr;
  std::optional<Push> push_;
  std::optional<int> armedPush_;
};

}  // namespace editor
