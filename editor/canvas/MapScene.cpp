#include "editor/canvas/MapScene.h"

#include <limits>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/RunOverlays.h"
#include "editor/document/PersonTree.h"

namespace editor {

namespace {

/// Z values from bottom to top.
enum Depth {
  MapDepth,
  GridDepth,
  AreaDepth,
  ObstacleDepth,
  DoorDepth,
  GroundOverlayDepth,
  GroupDepth,
  RouteDepth,
  RobotDepth,
  PersonDepth,
  GoalDepth,
  FrameDepth,
  TopOverlayDepth,
  SelectionDepth,
  LabelDepth,
  ToolDepth
};

Depth depthOf(EntityKind kind) {
  static const std::map<EntityKind, Depth> kDepths = {
      {EntityKind::Area, AreaDepth},   {EntityKind::Obstacle, ObstacleDepth},
      {EntityKind::Door, DoorDepth},   {EntityKind::Dock, DoorDepth},
      {EntityKind::Robot, RobotDepth}, {EntityKind::Human, PersonDepth},
      {EntityKind::Goal, GoalDepth}};
  return kDepths.at(kind);
}

constexpr double kPlaneMargin = 400.0;  // Pannable margin around the contents [m].

template <class Layer, class... More>
Layer* addLayer(MapScene& scene, Depth depth, More&&... more) {
  auto* layer = new Layer(scene, std::forward<More>(more)...);
  layer->setZValue(depth);
  scene.addItem(layer);  // The scene owns it.
  return layer;
}

/// The option that shows entities of this kind; null: always shown.
bool CanvasOptions::*layerOf(EntityKind kind) {
  switch (kind) {
    case EntityKind::Human:
      return &CanvasOptions::people;
    case EntityKind::Robot:
      return &CanvasOptions::robots;
    case EntityKind::Goal:
      return &CanvasOptions::goals;
    case EntityKind::Obstacle:
    case EntityKind::Door:
      return &CanvasOptions::obstacles;
    case EntityKind::Area:
    case EntityKind::Dock:
      return &CanvasOptions::areas;
    default:
      return nullptr;
  }
}

constexpr double kGhost = 0.7;    // Opacity of entities that do not exist yet.
constexpr double kFaded = 0.2;    // Opacity.
constexpr double kReachPx = 6.0;  // Maximum distance from the mouse.

constexpr double kRoom = 0.5;  // Margin around entities [m].

/// Bounding box of the known cells, or of all cells if none is known; empty for an open plane.
QRectF knownGroundOf(const sim2d::OccupancyGrid& grid) {
  int left = grid.width(), right = -1, bottom = grid.height(), top = -1;
  for (int row = 0; row < grid.height(); ++row) {
    const std::int8_t* cells =
        grid.cells().data() + static_cast<std::ptrdiff_t>(row) * grid.width();
    const auto* const end = cells + grid.width();
    const auto isKnown = [](std::int8_t cell) { return cell >= 0; };
    const auto* const first = std::find_if(cells, end, isKnown);
    if (first == end) {
      continue;
    }
    left = std::min(left, static_cast<int>(first - cells));
    int last = grid.width() - 1;
    while (last > right && cells[last] < 0) {
      --last;
    }
    right = std::max(right, last);
    bottom = std::min(bottom, row);
    top = row;
  }
  if (right < 0) {
    left = bottom = 0;
    right = grid.width() - 1;
    top = grid.height() - 1;
  }
  QPolygonF corners;
  for (const int column : {left, right + 1}) {
    for (const int row : {bottom, top + 1}) {
      corners << toScene(grid.cornerToWorld(column, row));
    }
  }
  return grid.isEmpty() ? QRectF() : corners.boundingRect();
}

/// Replaces the value with the same id, or appends it to its list.
void putIntoScenario(sim2d::Scenario& scenario, const Entity& value) {
  forEachList(scenario, [&](EntityKind /*kind*/, auto& list) {
    using Value = typename std::decay_t<decltype(list)>::value_type;
    if (const auto* wanted = std::get_if<Value>(&value)) {
      const int at = positionIn(list, wanted->key);
      (at < 0 ? list.emplace_back() : list[static_cast<std::size_t>(at)]) = *wanted;
    }
  });
}

}  // namespace

MapScene::MapScene(ScenarioDocument& document, const Theme& theme, QObject* parent)
    : QGraphicsScene(parent),
      document_(document),
      theme_(theme),
      sprites_(std::make_unique<SpriteAtlas>()),
      overlays_(std::make_unique<RunOverlays>(*this)),
      routes_(new RouteModel(this)) {
  setItemIndexMethod(QGraphicsScene::NoIndex);
  mapItem_ = addLayer<MapItem>(*this, MapDepth);
  gridItem_ = addLayer<GridItem>(*this, GridDepth);
  groupLayer_ = addLayer<GroupLayer>(*this, GroupDepth);
  routeLayer_ = addLayer<RouteLayer>(*this, RouteDepth);
  frameLayer_ = addLayer<FrameLayer>(*this, FrameDepth);
  groundOverlay_ = addLayer<OverlayLayer>(*this, GroundOverlayDepth, *overlays_, true);
  topOverlay_ = addLayer<OverlayLayer>(*this, TopOverlayDepth, *overlays_, false);
  selectionLayer_ = addLayer<SelectionLayer>(*this, SelectionDepth);
  labelLayer_ = addLayer<LabelLayer>(*this, LabelDepth);
  toolLayer_ = addLayer<ToolLayer>(*this, ToolDepth);
  connect(&document_, &ScenarioDocument::changed, this, &MapScene::apply);
  connect(&document_, &ScenarioDocument::mapChanged, this, &MapScene::updateMap);
  connect(&document_, &ScenarioDocument::selectionChanged, this, &MapScene::syncItems);
  connect(&document_, &ScenarioDocument::selectionChanged, this, [this] {
    if (!document_.selection().empty()) {
      setSpawnedAgent({});  // A document selection replaces the selected agent.
    }
  });
  connect(routes_, &RouteModel::routesChanged, this, &MapScene::updateRoutes);
  updateMap();
  rebuildAll();
}

void MapScene::addRunLayer(std::unique_ptr<FullLayer> layer) {
  constexpr double kBeneath = 0.5;
  layer->setZValue(double{FrameDepth} - kBeneath);
  runLayers_.push_back(layer.get());
  addItem(layer.release());
}

MapScene::~MapScene() {
  // Items access the scene, so they are deleted before its members.
  QGraphicsScene::clear();
}

void MapScene::updateMap() {
  mapItem_->refresh();
  knownGround_ = knownGroundOf(*document_.map());
  updateExtent();
  planRoutes();
  invalidateResting();
}

void MapScene::updateExtent() {
  extent_ = contentRect().adjusted(-kPlaneMargin, -kPlaneMargin, kPlaneMargin, kPlaneMargin);
  setSceneRect(extent_);
}

void MapScene::setRunArea(const QRectF& area) {
  if (area != runArea_) {
    runArea_ = area;
    updateExtent();
    invalidateResting();
  }
}

QRectF MapScene::groundRect() const {
  return isOpenPlane() ? extent_ : mapItem_->boundingRect();
}

QRectF MapScene::contentRect() const {
  QRectF content = knownGround_;
  if (!runArea_.isEmpty()) {
    return content | runArea_;
  }
  for (const auto& [id, entityItem] : items_) {
    const std::optional<Entity> value = shown(id);
    if (const std::optional<Extent> extent = value ? extentOf(*value) : std::nullopt) {
      const QPointF low = toScene(extent->low);
      const QPointF high = toScene(extent->high);
      content |= QRectF(low, high).normalized().adjusted(-kRoom, -kRoom, kRoom, kRoom);
    }
    const auto* robot = value ? std::get_if<sim2d::Robot>(&*value) : nullptr;
    if (robot != nullptr && robot->goal.point) {
      content |= around(toScene(*robot->goal.point), kRoom);
    }
  }
  return content.isEmpty() ? QRectF(-8.0, -6.0, 16.0, 12.0) : content;
}

void MapScene::setTheme(const Theme& theme) {
  theme_ = theme;
  mapItem_->refresh();
  sprites_->clear();
  overlays_->themeChanged();
  invalidateResting();
  Q_EMIT themeChanged();
}

void CanvasOptions::setOpacity(bool CanvasOptions::*layer, double opacity) {
  opacities.erase(std::remove_if(opacities.begin(), opacities.end(),
                                 [layer](const auto& each) { return each.first == layer; }),
                  opacities.end());
  if (opacity < 1.0) {
    opacities.emplace_back(layer, opacity);
  }
}

void MapScene::setOptions(const CanvasOptions& options) {
  const bool isOtherOpacity = options.opacities != options_.opacities;
  options_ = options;
  mapItem_->setVisible(options_.map);
  if (isOtherOpacity) {
    applyOpacities();
  }
  syncItems();
  Q_EMIT optionsChanged();
}

void MapScene::apply(const Change& change) {
  if (change.what == Change::What::Everything || change.entity.kind == EntityKind::Scenario) {
    rebuildAll();
    return;
  }
  if (change.what == Change::What::Removed) {
    drop(change.entity);
  } else {
    sync(change.entity);
  }
  planRoutes();
  invalidateResting();
}

void MapScene::rebuildAll() {
  for (const auto& [id, entityItem] : items_) {
    delete entityItem;
  }
  items_.clear();
  forEachList(document_.scenario(), [this](EntityKind /*kind*/, const auto& list) {
    for (const auto& value : list) {
      sync(value.key);
    }
  });
  updateExtent();
  planRoutes();
  invalidateResting();
}

void MapScene::drop(EntityId id) {
  delete item(id);
  items_.erase(id);
}

void MapScene::sync(EntityId id) {
  const std::optional<Entity> value = shown(id);
  if (!value) {
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

/// Updates the visibility and size of all items from options, selection and run.
void MapScene::syncItems() {
  for (const auto& [id, entityItem] : items_) {
    entityItem->zoomChanged();
    entityItem->setVisible(isShown(id));
  }
  invalidateResting();
}

EntityId MapScene::entityAt(const Vec2& world) const {
  const double reach = kReachPx / pixelsPerMetre_;
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
  const bool wasOnTop = !hovered_ || hoveredOnTop() == hovered_;
  hovered_ = id;
  if (wasOnTop && (!id || hoveredOnTop() == id)) {
    update();
  } else {
    invalidateResting();
  }
}

void MapScene::setPixelsPerMetre(double value) {
  pixelsPerMetre_ = value;
  for (const auto& [id, entityItem] : items_) {
    entityItem->zoomChanged();
  }
  sprites_->clear();
}

void MapScene::setPreview(const std::vector<Entity>& values) {
  std::map<EntityId, Entity> old;
  old.swap(preview_);
  for (const Entity& value : values) {
    preview_[idOf(value)] = value;
  }
  for (const auto& [id, value] : old) {
    if (preview_.count(id) == 0) {
      document_.contains(id) ? sync(id) : drop(id);
    }
  }
  for (const auto& [id, value] : preview_) {
    sync(id);
  }
  showGhosts();
  planRoutes();
  update();
}

void MapScene::showGhosts() {
  for (const auto& [id, value] : preview_) {
    if (!document_.contains(id)) {
      items_.at(id)->setOpacity(kGhost * layerOpacity(id.kind));
    }
  }
}

void MapScene::setFaded(const std::vector<EntityId>& ids) {
  const std::vector<EntityId> old = std::exchange(faded_, ids);
  for (const EntityId id : old) {
    sync(id);  // Restores the opacity.
  }
  for (const EntityId id : faded_) {
    if (EntityItem* const entityItem = item(id)) {
      entityItem->setOpacity(kFaded * layerOpacity(id.kind));
    }
  }
  invalidateResting();
}

/// According to the layers; in a run the frame layer draws people and robots instead.
bool MapScene::isShown(EntityId id) const {
  bool CanvasOptions::*const layer = layerOf(id.kind);
  const bool isBody = id.kind == EntityKind::Human || id.kind == EntityKind::Robot;
  return (layer == nullptr || options_.*layer) && !(isBody && isRunMode());
}

double MapScene::layerOpacity(EntityKind kind) const {
  bool CanvasOptions::*const layer = layerOf(kind);
  return layer == nullptr ? 1.0 : options_.opacityOf(layer);
}

void MapScene::applyOpacities() {
  const std::pair<QGraphicsItem*, bool CanvasOptions::*> parts[] = {
      {mapItem_, &CanvasOptions::map},
      {gridItem_, &CanvasOptions::grid},
      {groupLayer_, &CanvasOptions::groups},
      {routeLayer_, &CanvasOptions::routes},
      {labelLayer_, &CanvasOptions::names}};
  for (const auto& [part, layer] : parts) {
    part->setOpacity(options_.opacityOf(layer));
  }
  for (const auto& [id, entityItem] : items_) {
    sync(id);
  }
  showGhosts();
  setFaded(std::vector<EntityId>(faded_));
}

void MapScene::planRoutes() {
  if (isRunMode()) {
    return;
  }
  routes_->request([this] {
    RouteModel::Input input{document_.scenario(), document_.map(), document_.surroundings(),
                            document_.mapStopFlag()};
    for (const auto& [id, value] : preview_) {
      putIntoScenario(input.scenario, value);
    }
    for (sim2d::Human& human : input.scenario.humans) {
      if (std::vector<int> goals = walkedGoals(document_, human); goals != human.goals) {
        human.goals = std::move(goals);
        human.cyclicGoals = false;
      }
    }
    return input;
  });
}

void MapScene::updateRoutes() {
  routeLayer_->routesChanged();
  const std::vector<EntityId>& changed = routes_->changed();
  const bool onlyMoving = std::all_of(changed.begin(), changed.end(),
                                      [this](EntityId id) { return preview_.count(id) > 0; });
  if (!onlyMoving) {
    invalidateResting();
  }
}

}  // namespace editor
