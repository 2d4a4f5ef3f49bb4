#include "editor/canvas/RouteLayer.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/FigurePainter.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/document/PersonLook.h"

namespace editor {

namespace {

constexpr double kSoftness = 0.6;      // [m]
constexpr double kArrowSpacing = 1.5;  // [m]
constexpr double kArrowPx = 7.0;
constexpr double kNarrowestArrows = 34.0;  // px between two heads

QPointF towards(const QPointF& from, const QPointF& to, double distance) {
  const QLineF line(from, to);
  return line.length() > 0.0 ? line.pointAt(std::min(1.0, distance / line.length())) : from;
}

}  // namespace

QPainterPath softPath(const std::vector<Vec2>& points, double softness) {
  QPainterPath path;
  if (points.empty()) {
    return path;
  }
  path.moveTo(MapScene::sceneFromWorld(points.front()));
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const QPointF before = MapScene::sceneFromWorld(points[i - 1]);
    const QPointF corner = MapScene::sceneFromWorld(points[i]);
    const QPointF after = MapScene::sceneFromWorld(points[i + 1]);
    const double in = std::min(softness, 0.5 * QLineF(corner, before).length());
    const double out = std::min(softness, 0.5 * QLineF(corner, after).length());
    path.lineTo(towards(corner, before, in));
    path.quadTo(corner, towards(corner, after, out));
  }
  path.lineTo(MapScene::sceneFromWorld(points.back()));
  return path;
}

void paintArrowHeads(QPainter& painter, const QPainterPath& scenePath, double spacing,
                     double sizePx, const Theme& theme) {
  const double pixelsPerMetre = pixelsPerMetreOf(painter);
  const double gap = std::max(spacing, kNarrowestArrows / pixelsPerMetre);
  const double length = scenePath.length();
  const FigurePainter figures(theme);
  QPen pen = painter.pen();
  pen.setStyle(Qt::SolidLine);
  pen.setCosmetic(false);
  const double first = std::max(0.5 * gap, 0.55);
  const int count = static_cast<int>(std::ceil((length - 0.3 - first) / gap));
  for (int i = 0; i < count; ++i) {
    const double at = first + i * gap;
    const double part = scenePath.percentAtLength(at);
    const PixelFrame frame(painter, scenePath.pointAtPercent(part));
    painter.setPen(pen);
    figures.arrowHead(painter, QPointF(), scenePath.angleAtPercent(part), sizePx);
  }
}

RouteLayer::RouteLayer(const MapScene& scene) : scene_(scene) {}

void RouteLayer::routesChanged() {
  prepareGeometryChange();
  bounds_ = QRectF();
  for (const EntityKind kind : {EntityKind::Human, EntityKind::Robot}) {
    for (const EntityId id : scene_.document().entities(kind)) {
      const EntityRoute* route = scene_.routes().route(id);
      if (route == nullptr) {
        continue;
      }
      for (const RouteLeg& leg : route->legs) {
        bounds_ |= softPath(leg.points, 0.0).boundingRect();
      }
    }
  }
  bounds_.adjust(-1.0, -1.0, 1.0, 1.0);
  update();
}

void RouteLayer::paintLeg(QPainter& painter, const RouteLeg& leg, const Style& style) const {
  const QPainterPath path = softPath(leg.points, kSoftness);
  QPen pen(leg.isReachable ? style.color : scene_.theme().color(Role::Error), style.widthPx,
           style.dashes, Qt::RoundCap, Qt::RoundJoin);
  if (!leg.isReachable) {
    pen.setStyle(Qt::CustomDashLine);
    pen.setDashPattern({3.0, 4.0});
  } else if (style.dashes == Qt::CustomDashLine) {
    pen.setDashPattern({3.5, 2.5});
  }
  pen.setCosmetic(true);
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(path);
  paintArrowHeads(painter, path, kArrowSpacing, kArrowPx + style.widthPx, scene_.theme());
}

void RouteLayer::paintRoute(QPainter& painter, EntityId id, bool whole, const Style& style) const {
  const EntityRoute* route = scene_.routes().route(id);
  if (route == nullptr) {
    return;
  }
  const std::size_t count =
      whole ? route->legs.size() : std::min<std::size_t>(1, route->legs.size());
  for (std::size_t i = 0; i < count; ++i) {
    paintLeg(painter, route->legs[i], style);
  }
}

void RouteLayer::paintPeople(QPainter& painter, bool selected) const {
  for (const EntityId id : scene_.document().entities(EntityKind::Human)) {
    if (scene_.document().isSelected(id) != selected) {
      continue;
    }
    const std::optional<Entity> value = scene_.shown(id);
    if (!value) {
      continue;
    }
    Style style;
    style.color =
        scene_.theme().line(lookOfPerson(scene_.document(), std::get<sim2d::Human>(*value)));
    style.widthPx = selected ? 2.6 : 1.8;
    style.color.setAlphaF(selected ? 1.0 : 0.62);
    paintRoute(painter, id, selected, style);
  }
}

void RouteLayer::paintRobots(QPainter& painter) const {
  for (const EntityId id : scene_.document().entities(EntityKind::Robot)) {
    const bool selected = scene_.document().isSelected(id);
    const Style style{scene_.theme().color(Role::RobotLine), selected ? 2.6 : 2.0,
                      Qt::CustomDashLine};
    paintRoute(painter, id, true, style);
  }
}

void RouteLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  if (scene_.options().routes) {
    paintPeople(*painter, false);
    paintRobots(*painter);
  }
  paintPeople(*painter, true);
}

}  // namespace editor
