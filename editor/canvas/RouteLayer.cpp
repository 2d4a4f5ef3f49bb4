#include "editor/canvas/RouteLayer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "editor/canvas/PixelFrame.h"
#include "editor/document/Groups.h"
#include "editor/look/FigurePainter.h"

namespace editor {

namespace {

constexpr double kSoftness = 0.6;      // [m]
constexpr double kArrowSpacing = 1.5;  // [m]
constexpr double kArrowPx = 7.0;
constexpr double kNarrowestArrows = 34.0;  // px between two heads
constexpr double kFewRoutes = 16.0;        // that may be seen at their full strength
constexpr double kFaintest = 0.16;
constexpr std::size_t kMostRounds = 6;    // people whose whole rounds are seen at once
constexpr double kFaintestChosen = 0.45;  // stands out of the others at any number

QPointF towards(const QPointF& from, const QPointF& to, double distance) {
  const QLineF line(from, to);
  return line.length() > 0.0 ? line.pointAt(std::min(1.0, distance / line.length())) : from;
}

}  // namespace

double routeStrength(std::size_t inSight) {
  const double count = std::max(1.0, static_cast<double>(inSight));
  return std::clamp(std::sqrt(kFewRoutes / count), kFaintest, 1.0);
}

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

namespace {

std::vector<std::pair<QPointF, double>> arrowHeads(const QPainterPath& scenePath, double gap) {
  std::vector<std::pair<QPointF, double>> heads;
  const double first = std::max(0.5 * gap, 0.55);
  const double last = scenePath.length() - 0.3;
  for (double at = first; at < last; at += gap) {
    const double part = scenePath.percentAtLength(at);
    heads.emplace_back(scenePath.pointAtPercent(part), scenePath.angleAtPercent(part));
  }
  return heads;
}

double arrowGap(double spacing, double pixelsPerMetre) {
  return std::max(spacing, kNarrowestArrows / pixelsPerMetre);
}

void paintHeads(QPainter& painter, const std::vector<std::pair<QPointF, double>>& heads,
                double sizePx, const Theme& theme) {
  const FigurePainter figures(theme);
  QPen pen = painter.pen();
  pen.setStyle(Qt::SolidLine);
  pen.setWidthF(pen.isCosmetic() ? pen.widthF() / pixelRatioOf(painter) : pen.widthF());
  pen.setCosmetic(false);
  for (const auto& [tip, degrees] : heads) {
    const PixelFrame frame(painter, tip);
    painter.setPen(pen);
    figures.arrowHead(painter, QPointF(), degrees, sizePx);
  }
}

}  // namespace

void paintArrowHeads(QPainter& painter, const QPainterPath& scenePath, double spacing,
                     double sizePx, const Theme& theme) {
  const double gap = arrowGap(spacing, pixelsPerMetreOf(painter));
  paintHeads(painter, arrowHeads(scenePath, gap), sizePx, theme);
}

RouteLayer::RouteLayer(const MapScene& scene) : scene_(scene) {
  setFlag(QGraphicsItem::ItemUsesExtendedStyleOption);
}

void RouteLayer::routesChanged() {
  prepareGeometryChange();
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::max());
  Vec2 high = -low;
  for (const EntityKind kind : {EntityKind::Human, EntityKind::Robot}) {
    for (const EntityId id : scene_.document().entities(kind)) {
      const EntityRoute* route = scene_.routes().route(id);
      if (route == nullptr) {
        continue;
      }
      for (const RouteLeg& leg : route->legs) {
        for (const Vec2& point : leg.points) {
          low = low.cwiseMin(point);
          high = high.cwiseMax(point);
        }
      }
    }
  }
  bounds_ = low.x() > high.x()
                ? QRectF()
                : QRectF(MapScene::sceneFromWorld(low), MapScene::sceneFromWorld(high))
                      .normalized()
                      .adjusted(-1.0, -1.0, 1.0, 1.0);
  for (auto line = lines_.begin(); line != lines_.end();) {
    line = scene_.routes().route(line->first) == nullptr ? lines_.erase(line) : std::next(line);
  }
  update();
}

RouteLayer::Line& RouteLayer::lineOf(EntityId id, std::size_t index, const RouteLeg& leg) {
  std::vector<Line>& lines = lines_[id];
  if (lines.size() <= index) {
    lines.resize(index + 1);
  }
  Line& line = lines[index];
  if (line.points != leg.points) {
    line.points = leg.points;
    line.path = softPath(leg.points, kSoftness);
    // Straight legs have flat bounds, which intersect nothing.
    line.bounds = line.path.controlPointRect().adjusted(-0.5, -0.5, 0.5, 0.5);
    line.gap = 0.0;
  }
  return line;
}

void RouteLayer::placeHeads(Line& line, double spacing, double pixelsPerMetre) {
  // In steps: a slow zoom does not move all heads all the time.
  const double steps = std::ceil(2.0 * std::log2(arrowGap(spacing, pixelsPerMetre)));
  const double gap = std::max(kArrowSpacing, std::exp2(0.5 * steps));
  if (line.gap != gap) {
    line.gap = gap;
    line.heads = arrowHeads(line.path, gap);
  }
}

/// Ways of people who are not selected, of which the window shows something.
std::size_t RouteLayer::countInSight(const QRectF& shown) {
  std::size_t count = 0;
  for (const EntityId id : scene_.document().entities(EntityKind::Human)) {
    const EntityRoute* route = scene_.routes().route(id);
    if (route != nullptr && !route->legs.empty() && !scene_.document().isSelected(id)) {
      count += lineOf(id, 0, route->legs.front()).bounds.intersects(shown) ? 1 : 0;
    }
  }
  return count;
}

void RouteLayer::paintLeg(QPainter& painter, const Line& line, bool isReachable,
                          const Style& style) const {
  QPen pen(isReachable ? style.color : scene_.theme().color(Role::Error), style.widthPx,
           style.dashes, Qt::RoundCap, Qt::RoundJoin);
  if (!isReachable) {
    pen.setStyle(Qt::CustomDashLine);
    pen.setDashPattern({3.0, 4.0});
  } else if (style.dashes == Qt::CustomDashLine) {
    pen.setDashPattern({3.5, 2.5});
  }
  makeCosmetic(pen, painter);
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(line.path);
  paintHeads(painter, line.heads, kArrowPx + style.widthPx, scene_.theme());
}

void RouteLayer::paintRoute(QPainter& painter, EntityId id, bool whole, const Style& style) {
  const EntityRoute* route = scene_.routes().route(id);
  if (route == nullptr || !scene_.isPainted(id)) {
    return;
  }
  const std::size_t count =
      whole ? route->legs.size() : std::min<std::size_t>(1, route->legs.size());
  for (std::size_t i = 0; i < count; ++i) {
    const RouteLeg& leg = route->legs[i];
    Line& line = lineOf(id, i, leg);
    if (line.bounds.intersects(exposed_)) {
      placeHeads(line, style.arrowSpacing, pixelsPerMetreOf(painter));
      paintLeg(painter, line, leg.isReachable, style);
    }
  }
}

void RouteLayer::paintPeople(QPainter& painter, bool selected) {
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
    const double strength = selected ? chosenStrength_ : strength_;
    style.widthPx = std::max(selected ? 1.6 : 1.0, (selected ? 2.6 : 1.8) * std::sqrt(strength));
    style.color.setAlphaF((selected ? 1.0 : 0.62) * strength);
    style.arrowSpacing = kArrowSpacing / strength;
    paintRoute(painter, id, selected && showsRounds_, style);
  }
}

void RouteLayer::paintRobots(QPainter& painter) {
  for (const EntityId id : scene_.document().entities(EntityKind::Robot)) {
    const bool selected = scene_.document().isSelected(id);
    const Style style{scene_.theme().color(Role::RobotLine), selected ? 2.6 : 2.0,
                      Qt::CustomDashLine};
    paintRoute(painter, id, true, style);
  }
}

void RouteLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) {
  painter->setRenderHint(QPainter::Antialiasing);
  exposed_ = option->exposedRect;
  const std::vector<EntityId>& selection = scene_.document().selection();
  const auto chosen =
      static_cast<std::size_t>(std::count_if(selection.begin(), selection.end(), [](EntityId id) {
        return id.kind == EntityKind::Human;
      }));
  showsRounds_ = chosen <= kMostRounds;
  chosenStrength_ = std::max(kFaintestChosen, routeStrength(showsRounds_ ? 1 : chosen));
  strength_ = routeStrength(countInSight(shownRect(*painter, *option, widget)));
  if (scene_.options().routes) {
    paintPeople(*painter, false);
    paintRobots(*painter);
  }
  paintPeople(*painter, true);
}

}  // namespace editor
