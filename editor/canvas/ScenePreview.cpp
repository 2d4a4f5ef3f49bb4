#include <algorithm>
#include <utility>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/RouteLayer.h"

// The part of MapScene that shows what is not so in the document, and the routes with it.
namespace editor {

namespace {

constexpr double kFaded = 0.2;  // opacity

}  // namespace

std::optional<Entity> MapScene::shown(EntityId id) const {
  const auto found = preview_.find(id);
  return found != preview_.end() ? std::optional<Entity>(found->second) : document_.entity(id);
}

void MapScene::setPreview(const std::vector<Entity>& values) {
  std::map<EntityId, Entity> old;
  old.swap(preview_);
  for (const Entity& value : values) {
    preview_[idOf(value)] = value;
  }
  for (const auto& [id, value] : old) {
    if (preview_.count(id) == 0) {
      endPreviewOf(id);
    }
  }
  for (const auto& [id, value] : preview_) {
    sync(id);
    if (!document_.contains(id)) {
      items_.at(id)->setOpacity(0.7);
    }
  }
  planRoutes();
  update();
}

void MapScene::endPreviewOf(EntityId id) {
  if (document_.contains(id)) {
    sync(id);
  } else {
    delete item(id);
    items_.erase(id);
  }
}

void MapScene::setFaded(const std::vector<EntityId>& ids) {
  const std::vector<EntityId> old = std::exchange(faded_, ids);
  for (const EntityId id : old) {
    sync(id);  // as clear as it was
  }
  for (const EntityId id : faded_) {
    if (EntityItem* const entityItem = item(id)) {
      entityItem->setOpacity(kFaded);
    }
  }
  noteChange();
}

/// What the layers menu shows; in a run the layer of frames stands for people and robots.
bool MapScene::isShown(EntityId id) const {
  switch (id.kind) {
    case EntityKind::Human:
      return options_.people && !isRunMode();
    case EntityKind::Robot:
      return options_.robots && !isRunMode();
    case EntityKind::Goal:
      return options_.goals;
    case EntityKind::Obstacle:
    case EntityKind::Door:
      return options_.obstacles;
    case EntityKind::Area:
      return options_.areas;
    default:
      return true;
  }
}

void MapScene::clearPreview() {
  if (!preview_.empty()) {
    setPreview({});
  }
}

void MapScene::planRoutes() {
  if (isRunMode()) {
    return;
  }
  routes_->request([this] {
    RouteModel::Input input{document_.scenario(), document_.map()};
    for (const auto& [id, value] : preview_) {
      putInto(input.scenario, value);
    }
    return input;
  });
}

void MapScene::takeRoutes() {
  routeLayer_->routesChanged();
  const std::vector<EntityId>& changed = routes_->changed();
  const bool onlyMoving = std::all_of(changed.begin(), changed.end(),
                                      [this](EntityId id) { return preview_.count(id) > 0; });
  if (!onlyMoving) {
    noteChange();
  }
}

}  // namespace editor
