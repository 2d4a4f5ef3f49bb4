#include <algorithm>

#include <QPainter>
#include <QStyleOptionGraphicsItem>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/GroupLayer.h"
#include "editor/canvas/Layers.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/RouteLayer.h"

// The part of MapScene that paints without a view, for pictures of what rests.
namespace editor {

namespace {

constexpr std::size_t kCrowd = 200;            // things
constexpr std::size_t kMostMovingRoutes = 20;  // drawn while they change

void paintItem(QPainter& painter, QGraphicsItem& item, const QRectF& exposed) {
  const QRectF seen = item.boundingRect() & exposed;
  if (!item.isVisible() || seen.isEmpty()) {
    return;
  }
  QStyleOptionGraphicsItem option;
  option.exposedRect = seen;
  painter.save();
  painter.setOpacity(item.effectiveOpacity());
  item.paint(&painter, &option, nullptr);
  painter.restore();
}

}  // namespace

QColor MapScene::groundColor() const {
  return theme_.color(isOpenPlane() ? Role::MapFree : Role::CanvasOutside);
}

bool MapScene::isCrowded() const {
  return items_.size() >= kCrowd;
}

std::vector<EntityId> MapScene::movingIds() const {
  std::vector<EntityId> ids;
  for (const auto& [id, value] : preview_) {
    ids.push_back(id);
  }
  return ids;
}

bool MapScene::isPainted(EntityId id) const {
  return part_ == CanvasPart::All || (part_ == CanvasPart::Moving) == (preview_.count(id) > 0);
}

/// What is small is painted once more over the rest while the mouse is over it, so that what rests
/// stays as it is.
EntityId MapScene::onTop() const {
  const bool isSmall = hovered_.kind == EntityKind::Human || hovered_.kind == EntityKind::Robot ||
                       hovered_.kind == EntityKind::Goal;
  return isSmall ? hovered_ : EntityId();
}

bool MapScene::isHovered(EntityId id) const {
  return id == hovered_ && (part_ != CanvasPart::Resting || onTop() != id);
}

void MapScene::paintPart(QPainter& painter, CanvasPart part, const QRectF& exposed) {
  part_ = part;
  std::vector<QGraphicsItem*> wanted;
  if (part == CanvasPart::Moving) {
    wanted = {groupLayer_, labelLayer_};
    if (preview_.size() <= kMostMovingRoutes) {
      wanted.push_back(routeLayer_);
    }
    for (const auto& [id, value] : preview_) {
      wanted.push_back(item(id));
    }
    QGraphicsItem* const hovered = item(onTop());
    if (hovered != nullptr && preview_.count(hovered_) == 0) {
      wanted.push_back(hovered);
    }
  } else {
    for (QGraphicsItem* each : items(Qt::AscendingOrder)) {
      const auto* entityItem = dynamic_cast<EntityItem*>(each);
      if (entityItem == nullptr || isPainted(entityItem->id())) {
        wanted.push_back(each);
      }
    }
  }
  const auto drop = [&](const QGraphicsItem* layer) {
    wanted.erase(std::remove(wanted.begin(), wanted.end(), layer), wanted.end());
  };
  drop(selectionLayer_);
  drop(toolLayer_);
  if (part != CanvasPart::Resting) {
    wanted.push_back(selectionLayer_);
    wanted.push_back(toolLayer_);
  }
  std::stable_sort(wanted.begin(), wanted.end(),
                   [](const auto* a, const auto* b) { return a->zValue() < b->zValue(); });
  for (QGraphicsItem* each : wanted) {
    paintItem(painter, *each, exposed);
  }
  part_ = CanvasPart::All;
}

}  // namespace editor
