#include "editor/canvas/Layers.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/Overlays.h"
#include "editor/canvas/PixelFrame.h"

namespace editor {

namespace {

constexpr double kTurnPx = 52.0;
constexpr double kShapeTurnPx = 24.0;    // beyond the outline
constexpr std::size_t kMostHandles = 8;  // things that show theirs
constexpr double kHandlePx = 8.0;
constexpr double kTurnHandlePx = 10.0;
constexpr double kHandleReachPx = 8.0;

QPen accentPen(const QPainter& painter, const Theme& theme, double widthPx) {
  return screenPen(painter, theme.color(Role::Accent), widthPx, Qt::SolidLine, Qt::SquareCap);
}

}  // namespace

void GridItem::paintLines(QPainter& painter, const QRectF& area, double step, double alpha) const {
  QColor color = theme().color(Role::Text);
  color.setAlphaF(alpha);
  QPen pen(color, 1.0);
  makeCosmetic(pen, painter);
  painter.setPen(pen);
  QVector<QLineF> lines;
  for (const double x : multiplesIn(area.left(), area.right(), step)) {
    lines << QLineF(x, area.top(), x, area.bottom());
  }
  for (const double y : multiplesIn(area.top(), area.bottom(), step)) {
    lines << QLineF(area.left(), y, area.right(), y);
  }
  painter.drawLines(lines);
}

void GridItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  if (!mapScene().options().grid) {
    return;
  }
  painter->setRenderHint(QPainter::Antialiasing, false);
  const QRectF area = boundingRect() & option->exposedRect.adjusted(-0.1, -0.1, 0.1, 0.1);
  const double pixelsPerMetre = pixelsPerMetreOf(*painter);
  const auto fade = [](double px) { return std::clamp((px - 8.0) / 22.0, 0.0, 1.0); };
  const double strength = theme().isDark() ? 0.055 : 0.07;
  for (const double step : {1.0, 5.0, 25.0}) {
    const double alpha = strength * fade(pixelsPerMetre * step);
    if (alpha > 0.0) {
      paintLines(*painter, area, step, alpha);
    }
  }
}

void FullLayer::setBounds(const QRectF& sceneBounds) {
  prepareGeometryChange();
  bounds_ = sceneBounds;
}

std::vector<Handle> SelectionLayer::handlesFor(const Entity& entity) const {
  const double pixelsPerMetre = mapScene().pixelsPerMetre();
  HandleSizes sizes;
  sizes.bodyRadius = mapScene().bodyRadius(entity);
  sizes.turnDistance = kTurnPx / pixelsPerMetre;
  if (kindOf(entity) != EntityKind::Human && kindOf(entity) != EntityKind::Robot) {
    sizes.turnDistance = kShapeTurnPx / pixelsPerMetre;
  }
  std::vector<Handle> handles = handlesOf(entity, sizes);
  const bool isSmall = sizes.bodyRadius * pixelsPerMetre < 12.0;
  if (isSmall && kindOf(entity) == EntityKind::Human) {  // handles would hide the figure
    handles.erase(
        std::remove_if(handles.begin(), handles.end(),
                       [](const Handle& handle) { return handle.kind == Handle::Kind::Size; }),
        handles.end());
  }
  return handles;
}

/// Those that are to be seen, each with the entity that it is of.
std::vector<std::pair<EntityId, Handle>> SelectionLayer::handles() const {
  std::vector<std::pair<EntityId, Handle>> all;
  const std::vector<EntityId>& selection = mapScene().document().selection();
  for (const EntityId id : selection.size() > kMostHandles ? std::vector<EntityId>() : selection) {
    if (const std::optional<Entity> entity = mapScene().shown(id)) {
      for (const Handle& handle : handlesFor(*entity)) {
        all.emplace_back(id, handle);
      }
    }
  }
  return all;
}

std::pair<EntityId, Handle> SelectionLayer::handleAt(const Vec2& world) const {
  const double reach = kHandleReachPx / mapScene().pixelsPerMetre();
  for (const auto& [id, handle] : handles()) {
    if ((handle.position - world).cwiseAbs().maxCoeff() <= reach) {
      return {id, handle};
    }
  }
  return {};
}

std::vector<QRectF> SelectionLayer::solidParts() const {
  const double reach = 0.75 * kTurnHandlePx / mapScene().pixelsPerMetre();
  std::vector<QRectF> parts;
  for (const auto& [id, handle] : handles()) {
    parts.push_back(around(MapScene::sceneFromWorld(handle.position), reach));
  }
  return parts;
}

void SelectionLayer::paintFrame(QPainter& painter, const Entity& entity,
                                const std::vector<Handle>& handles) const {
  painter.setPen(accentPen(painter, theme(), 2.0));
  painter.setBrush(Qt::NoBrush);
  QPolygonF frame;
  for (const Handle& handle : handles) {
    if (handle.kind == Handle::Kind::Size || handle.kind == Handle::Kind::Vertex) {
      frame << MapScene::sceneFromWorld(handle.position);
    }
  }
  const auto* obstacle = std::get_if<sim2d::Obstacle>(&entity);
  const bool isOpen = kindOf(entity) == EntityKind::Door ||
                      (obstacle != nullptr && obstacle->kind == sim2d::ObstacleKind::Wall);
  if (isOpen) {
    painter.drawPolyline(frame);
  } else if (frame.size() > 2) {
    painter.drawPolygon(frame);
  } else if (kindOf(entity) == EntityKind::Human || kindOf(entity) == EntityKind::Robot) {
    const double pixelsPerMetre = pixelsPerMetreOf(painter);
    const double radius =
        std::max(mapScene().bodyRadius(entity), 5.0 / pixelsPerMetre) + 4.0 / pixelsPerMetre;
    painter.drawEllipse(MapScene::sceneFromWorld(*positionOf(entity)), radius, radius);
  }
}

void SelectionLayer::paintHandle(QPainter& painter, const Entity& entity,
                                 const Handle& handle) const {
  const QPointF at = MapScene::sceneFromWorld(handle.position);
  const bool isTurn = handle.kind == Handle::Kind::Turn;
  if (isTurn) {
    painter.setPen(accentPen(painter, theme(), 1.5));
    const QLineF arm(MapScene::sceneFromWorld(*positionOf(entity)), at);
    painter.drawLine(arm.pointAt(0.5), at);
  }
  const PixelFrame frame(painter, at);
  painter.setPen(QPen(theme().color(Role::Accent), 2.0));
  painter.setBrush(theme().color(Role::Panel));
  if (isTurn) {
    painter.drawEllipse(QPointF(), 0.5 * kTurnHandlePx, 0.5 * kTurnHandlePx);
  } else if (handle.kind == Handle::Kind::RobotGoal) {
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(QPointF(), 14.0, 14.0);
  } else {
    painter.setPen(QPen(theme().color(Role::Accent), 1.5));
    painter.drawRect(QRectF(-0.5 * kHandlePx, -0.5 * kHandlePx, kHandlePx, kHandlePx));
  }
}

void SelectionLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  if (mapScene().isRunMode()) {
    return;
  }
  painter->setRenderHint(QPainter::Antialiasing);
  const std::vector<EntityId>& selection = mapScene().document().selection();
  for (const EntityId id : selection) {
    const std::optional<Entity> entity = mapScene().shown(id);
    const EntityItem* item = mapScene().item(id);
    const bool isSeen = item != nullptr && item->isVisible() &&
                        item->boundingRect().intersects(option->exposedRect);
    if (!entity || (!isSeen && selection.size() > kMostHandles)) {
      continue;
    }
    const std::vector<Handle> handles = handlesFor(*entity);
    paintFrame(*painter, *entity, handles);
    if (selection.size() <= kMostHandles) {
      for (const Handle& handle : handles) {
        paintHandle(*painter, *entity, handle);
      }
    }
  }
}

}  // namespace editor
