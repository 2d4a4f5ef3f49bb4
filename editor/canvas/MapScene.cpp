#include "editor/canvas/MapScene.h"

#include <algorithm>
#include <limits>

#include <QGraphicsSceneMouseEvent>
#include <QKeyEvent>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/GroupLayer.h"
#include "editor/canvas/Layers.h"
#include "editor/canvas/MapItem.h"
#include "editor/canvas/RouteLayer.h"
#include "editor/canvas/SpriteAtlas.h"
#include "editor/canvas/Tool.h"
#include "sim2d/scenario/Defaults.h"

namespace editor {

namespace {

/// From the ground up; used as z values.
enum Depth {
  MapDepth,
  GridDepth,
  AreaDepth,
  ObstacleDepth,
  DoorDepth,
  GroupDepth,
  RouteDepth,
  RobotDepth,
  PersonDepth,
  GoalDepth,
  FrameDepth,
  SelectionDepth,
  LabelDepth,
  ToolDepth
};

Depth depthOf(EntityKind kind) {
  switch (kind) {
    case EntityKind::Area:
      return AreaDepth;
    case EntityKind::Obstacle:
      return ObstacleDepth;
    case EntityKind::Door:
      return DoorDepth;
    case EntityKind::Robot:
      return RobotDepth;
    case EntityKind::Goal:
      return GoalDepth;
    default:
      return PersonDepth;
  }
}

constexpr double kPlaneMargin = 400.0;  // [m] around the contents: as far as one can pan

template <class Layer, class... Arguments>
Layer* addLayer(QGraphicsScene& scene, Depth depth, Arguments&&... arguments) {
  auto* layer = new Layer(std::forward<Arguments>(arguments)...);
  layer->setZValue(depth);
  scene.addItem(layer);  // the scene owns it
  return layer;
}

}  // namespace

MapScene::MapScene(ScenarioDocument& document, const Theme& theme, QObject* parent)
    : QGraphicsScene(parent),
      document_(document),
      theme_(theme),
      sprites_(std::make_unique<SpriteAtlas>()),
      routes_(new RouteModel(this)) {
  setItemIndexMethod(QGraphicsScene::NoIndex);
  mapItem_ = addLayer<MapItem>(*this, MapDepth);
  gridItem_ = addLayer<GridItem>(*this, GridDepth, *this);
  groupLayer_ = addLayer<GroupLayer>(*this, GroupDepth, *this);
  routeLayer_ = addLayer<RouteLayer>(*this, RouteDepth, *this);
  frameLayer_ = addLayer<FrameLayer>(*this, FrameDepth, *this);
  selectionLayer_ = addLayer<SelectionLayer>(*this, SelectionDepth, *this);
  labelLayer_ = addLayer<LabelLayer>(*this, LabelDepth, *this);
  toolLayer_ = addLayer<ToolLayer>(*this, ToolDepth, *this);
  connect(&document_, &ScenarioDocument::changed, this, &MapScene::apply);
  connect(&document_, &ScenarioDocument::mapChanged, this, &MapScene::takeMap);
  connect(&document_, &ScenarioDocument::selectionChanged, this, &MapScene::syncSelection);
  connect(routes_, &RouteModel::routesChanged, this, &MapScene::takeRoutes);
  takeMap();
  rebuildAll();
}

MapScene::~MapScene() {
  // Items look at the scene; they go before its members do.
  QGraphicsScene::clear();
}

void MapScene::noteChange() {
  ++restingRevision_;
  update();
}

void MapScene::takeMap() {
  mapItem_->set(document_.map(), theme_);
  updateExtent();
  planRoutes();
  noteChange();
}

void MapScene::updateExtent() {
  const QRectF content = contentRect();
  const QRectF extent = content.adjusted(-kPlaneMargin, -kPlaneMargin, kPlaneMargin, kPlaneMargin);
  setSceneRect(extent);
  gridItem_->setBounds(mapItem_->isOpenPlane() ? extent : mapItem_->boundingRect());
  for (FullLayer* layer :
       {static_cast<FullLayer*>(groupLayer_), static_cast<FullLayer*>(selectionLayer_),
        static_cast<FullLayer*>(labelLayer_), static_cast<FullLayer*>(toolLayer_)}) {
    layer->setBounds(extent);
  }
}

bool MapScene::isOpenPlane() const {
  return mapItem_->isOpenPlane();
}

QRectF MapScene::contentRect() const {
  QRectF content = mapItem_->boundingRect();
  for (const auto& [id, entityItem] : items_) {
    content |= entityItem->boundingRect();
  }
  return content.isEmpty() ? QRectF(-8.0, -6.0, 16.0, 12.0) : content;
}

void MapScene::setTheme(const Theme& theme) {
  theme_ = theme;
  mapItem_->set(document_.map(), theme_);
  frameLayer_->themeChanged();
  sprites_->clear();
  noteChange();
  Q_EMIT themeChanged();
}

void MapScene::setOptions(const CanvasOptions& options) {
  options_ = options;
  mapItem_->setVisible(options_.map);
  for (const auto& [id, entityItem] : items_) {
    entityItem->zoomChanged();
    entityItem->setVisible(isShown(id));
  }
  noteChange();
  Q_EMIT optionsChanged();
}

void MapScene::apply(const Change& change) {
  switch (change.what) {
    case Change::What::Everything:
      rebuildAll();
      return;
    case Change::What::Removed:
      delete item(change.entity);
      items_.erase(change.entity);
      break;
    default:
      sync(change.entity);
  }
  if (change.entity.kind == EntityKind::Scenario) {
    rebuildAll();
    return;
  }
  planRoutes();
  noteChange();
}

void MapScene::rebuildAll() {
  for (const auto& [id, entityItem] : items_) {
    delete entityItem;
  }
  items_.clear();
  for (const EntityKind kind : {EntityKind::Area, EntityKind::Obstacle, EntityKind::Door,
                                EntityKind::Goal, EntityKind::Robot, EntityKind::Human}) {
    for (const EntityId id : document_.entities(kind)) {
      sync(id);
    }
  }
  updateExtent();
  planRoutes();
  noteChange();
}

void MapScene::sync(EntityId id) {
  const std::optional<Entity> value = shown(id);
  if (!value || id.kind == EntityKind::Scenario) {
    return;
  }
  EntityItem*& entityItem = items_[id];
  if (entityItem == nullptr) {
    entityItem = makeEntityItem(*this, id).release();
    entityItem->setZValue(depthOf(id.kind));
    addItem(entityItem);
    entityItem->setVisible(isShown(id));
  }
  entityItem->sync(*value);
}

void MapScene::syncSelection() {
  for (const auto& [id, entityItem] : items_) {
    entityItem->zoomChanged();
  }
  noteChange();
}

EntityItem* MapScene::item(EntityId id) const {
  const auto found = items_.find(id);
  return found == items_.end() ? nullptr : found->second;
}

EntityId MapScene::entityAt(const Vec2& world, double reachPx) const {
  const double reach = reachPx / pixelsPerMetre_;
  EntityId best;
  double bestDepth = -1.0;
  double bestDistance = std::numeric_limits<double>::max();
  for (const auto& [id, entityItem] : items_) {
    const double distance = entityItem->isVisible() ? entityItem->distanceTo(world) : reach + 1.0;
    const double depth = entityItem->zValue();
    const bool isBetter = depth > bestDepth || (depth == bestDepth && distance < bestDistance);
    if (distance <= reach && isBetter && document_.contains(id)) {
      best = id;
      bestDepth = depth;
      bestDistance = distance;
    }
  }
  return best;
}

std::vector<EntityId> MapScene::entitiesIn(const Vec2& corner, const Vec2& opposite) const {
  const Vec2 low = corner.cwiseMin(opposite);
  const Vec2 high = corner.cwiseMax(opposite);
  std::vector<EntityId> found;
  for (const auto& [id, entityItem] : items_) {
    const std::optional<Entity> value = document_.entity(id);
    const std::optional<Vec2> at = value ? positionOf(*value) : std::nullopt;
    if (at && entityItem->isVisible() && (at->array() >= low.array()).all() &&
        (at->array() <= high.array()).all()) {
      found.push_back(id);
    }
  }
  return found;
}

void MapScene::setHovered(EntityId id) {
  if (hovered_ == id) {
    return;
  }
  const bool wasOnTop = !hovered_ || onTop() == hovered_;
  hovered_ = id;
  if (wasOnTop && (!id || onTop() == id)) {
    update();
  } else {
    noteChange();
  }
  Q_EMIT hoveredChanged(id);
}

void MapScene::setPixelsPerMetre(double value) {
  pixelsPerMetre_ = value;
  for (const auto& [id, entityItem] : items_) {
    entityItem->zoomChanged();
  }
  frameLayer_->zoomChanged();
  sprites_->clear();
}

}  // namespace editor
