#pragma once

#include <map>
#include <memory>
#include <vector>

#include <QGraphicsScene>

#include "editor/document/ScenarioDocument.h"
#include "editor/look/Theme.h"
#include "sim2d/trace/Frame.h"

namespace editor {

class EntityItem;
class FrameLayer;
class LabelLayer;
class MapItem;
class RouteModel;
class Tool;
class ToolLayer;

/// Which extras are drawn; all can be switched one by one.
struct CanvasOptions {
  bool names = true, routes = true, grid = true, rulers = false;
  bool trails = true, robotPath = true, speech = true, proxemics = false, forces = false;
};

/// Draws the document: items follow its changes; the mouse goes to the current tool. Scene
/// coordinates are metres with y down: scene = (x, -y).
class MapScene : public QGraphicsScene {
  Q_OBJECT
 public:
  MapScene(ScenarioDocument& document, const Theme& theme, QObject* parent = nullptr);
  ~MapScene() override;

  static QPointF sceneFromWorld(const Vec2& point) { return {point.x(), -point.y()}; }
  static Vec2 worldFromScene(const QPointF& point) { return {point.x(), -point.y()}; }

  const ScenarioDocument& document() const { return document_; }
  const Theme& theme() const { return theme_; }
  void setTheme(const Theme& theme);
  const CanvasOptions& options() const { return options_; }
  void setOptions(const CanvasOptions& options);

  void setTool(Tool* tool);
  Tool* tool() const { return tool_; }

  /// The topmost entity within `reachPx` screen pixels; none if there is none.
  EntityId entityAt(const Vec2& world, double reachPx = 6.0) const;
  std::vector<EntityId> entitiesIn(const Vec2& corner, const Vec2& opposite) const;
  EntityItem* item(EntityId id) const;
  void setHovered(EntityId id);
  EntityId hovered() const { return hovered_; }

  /// Shows these values instead of the document's until cleared; new ones (without a key in the
  /// document) are shown as ghosts.
  void setPreview(const std::vector<Entity>& values);
  void clearPreview();
  std::optional<Entity> shown(EntityId id) const;  // preview or document

  double pixelsPerMetre() const { return pixelsPerMetre_; }
  void setPixelsPerMetre(double value);  // by the view
  QRectF contentRect() const;            // map and entities [m]

  /// Run mode: people and robots are drawn from frames; an empty pointer ends it.
  void showFrame(std::shared_ptr<const sim2d::Frame> frame);
  bool isRunMode() const;
  FrameLayer& frameLayer() { return *frameLayer_; }
  RouteModel& routes() { return *routes_; }
  ToolLayer& toolLayer() { return *toolLayer_; }

 Q_SIGNALS:
  void hoveredChanged(editor::EntityId id);
  void optionsChanged();
  void themeChanged();

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
  void syncSelection();

  ScenarioDocument& document_;
  Theme theme_;
  CanvasOptions options_;
  Tool* tool_ = nullptr;
  EntityId hovered_;
  double pixelsPerMetre_ = 50.0;
  std::map<EntityId, EntityItem*> items_;
  std::map<EntityId, Entity> preview_;
  MapItem* mapItem_ = nullptr;
  FrameLayer* frameLayer_ = nullptr;
  LabelLayer* labelLayer_ = nullptr;
  ToolLayer* toolLayer_ = nullptr;
  RouteModel* routes_ = nullptr;
};

}  // namespace editor
