#include <cmath>

#include "editor/canvas/Layers.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/document/PeopleEdits.h"
#include "editor/document/RunValues.h"

namespace editor {

namespace {

constexpr double kCornerDeviation = 0.6;  // [m]
constexpr double kArrowSpacing = 1.5;     // [m]
constexpr double kArrowPx = 7.0;
constexpr double kNarrowestArrows = 34.0;  // Minimum distance between two heads [px].
constexpr double kFewRoutes = 16.0;        // Maximum number of routes at full opacity.
constexpr double kFaintest = 0.16;
constexpr std::size_t kMaxLegs = 48;  // Maximum number of legs with which full routes are shown.
constexpr std::size_t kLegsPerRoute = 2;  // Legs of a full route that count as one route.
constexpr double kFaintestChosen = 0.45;  // Stands out at any number of routes.

QPointF towards(const QPointF& from, const QPointF& to, double distance) {
  const QLineF line(from, to);
  return line.length() > 0.0 ? line.pointAt(std::min(1.0, distance / line.length())) : from;
}

std::vector<std::pair<QPointF, double>> arrowHeads(const QPainterPath& scenePath, double gap) {
  std::vector<std::pair<QPointF, double>> heads;
  const double first = std::max(0.5 * gap, 0.55);
  const double last = scenePath.length() - 0.3;
  double at = first;
  while (at < last) {
    const double part = scenePath.percentAtLength(at);
    heads.emplace_back(scenePath.pointAtPercent(part), scenePath.angleAtPercent(part));
    at += gap;
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

double routeOpacity(std::size_t inSight) {
  const double count = std::max(1.0, static_cast<double>(inSight));
  return std::clamp(std::sqrt(kFewRoutes / count), kFaintest, 1.0);
}

QPainterPath roundedPath(const std::vector<Vec2>& points, double softness) {
  QPainterPath path;
  if (points.empty()) {
    return path;
  }
  path.moveTo(toScene(points.front()));
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const QPointF before = toScene(points[i - 1]);
    const QPointF corner = toScene(points[i]);
    const QPointF after = toScene(points[i + 1]);
    const double in = std::min(softness, 0.5 * QLineF(corner, before).length());
    const double out = std::min(softness, 0.5 * QLineF(corner, after).length());
    path.lineTo(towards(corner, before, in));
    path.quadTo(corner, towards(corner, after, out));
  }
  path.lineTo(toScene(points.back()));
  return path;
}

void paintArrowHeads(QPainter& painter, const QPainterPath& scenePath, double spacing,
                     double sizePx, const Theme& theme) {
  paintHeads(painter, arrowHeads(scenePath, arrowGap(spacing, pixelsPerMetreOf(painter))), sizePx,
             theme);
}

/// Removes the cached lines of entities without a route.
void RouteLayer::routesChanged() {
  for (auto line = lines_.begin(); line != lines_.end();) {
    const bool isKept = mapScene().routes().route(line->first) != nullptr;
    line = isKept ? std::next(line) : lines_.erase(line);
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
    line.path = roundedPath(leg.points, kCornerDeviation);
    // Straight legs have bounds of zero height or width, which intersect nothing.
    line.bounds = line.path.controlPointRect().adjusted(-0.5, -0.5, 0.5, 0.5);
    line.gap = 0.0;
  }
  return line;
}

void RouteLayer::placeHeads(Line& line, double spacing, double pixelsPerMetre) {
  // Quantized, so that a slow zoom does not move all heads continuously.
  const double steps = std::ceil(2.0 * std::log2(arrowGap(spacing, pixelsPerMetre)));
  const double gap = std::max(kArrowSpacing, std::exp2(0.5 * steps));
  if (line.gap != gap) {
    line.gap = gap;
    line.heads = arrowHeads(line.path, gap);
  }
}

/// Number of routes of unselected people that are at least partly in view.
std::size_t RouteLayer::countVisibleRoutes(const QRectF& shown) {
  std::size_t count = 0;
  for (const EntityId id : document().entities(EntityKind::Human)) {
    const EntityRoute* route = mapScene().routes().route(id);
    if (route != nullptr && !route->empty() && !document().isSelected(id)) {
      count += lineOf(id, 0, route->front()).bounds.intersects(shown) ? 1 : 0;
    }
  }
  return count;
}

void RouteLayer::paintLeg(QPainter& painter, const Line& line, bool isReachable,
                          const Style& style) const {
  QPen pen(isReachable ? style.color : theme().color(Role::Error), style.widthPx, style.dashes,
           Qt::RoundCap, Qt::RoundJoin);
  if (!isReachable) {
    pen.setStyle(Qt::CustomDashLine);
    pen.setDashPattern({3.0, 4.0});
  } else if (style.dashes == Qt::CustomDashLine) {
    pen.setDashPattern({3.5, 2.5});
  }
  setPenAndBrush(painter, cosmetic(pen, painter));
  painter.drawPath(line.path);
  paintHeads(painter, line.heads, kArrowPx + style.widthPx, theme());
}

void RouteLayer::paintRoute(QPainter& painter, EntityId id, bool whole, const Style& style) {
  const EntityRoute* route = mapScene().routes().route(id);
  if (route == nullptr || !mapScene().isPainted(id)) {
    return;
  }
  const std::size_t count = whole ? route->size() : std::min<std::size_t>(1, route->size());
  for (std::size_t i = 0; i < count; ++i) {
    const RouteLeg& leg = (*route)[i];
    Line& line = lineOf(id, i, leg);
    if (line.bounds.intersects(exposed_)) {
      placeHeads(line, style.arrowSpacing, pixelsPerMetreOf(painter));
      paintLeg(painter, line, leg.isReachable, style);
    }
  }
}

void RouteLayer::paintPeople(QPainter& painter, bool selected) {
  for (const EntityId id : document().entities(EntityKind::Human)) {
    if (document().isSelected(id) != selected) {
      continue;
    }
    const std::optional<Entity> value = mapScene().shown(id);
    if (!value) {
      continue;
    }
    Style style;
    style.color = theme().line(shownLookOf(document(), std::get<sim2d::Human>(*value)));
    const double strength = selected ? selectedOpacity_ : opacity_;
    style.widthPx = std::max(selected ? 1.6 : 1.0, (selected ? 2.6 : 1.8) * std::sqrt(strength));
    style.color.setAlphaF((selected ? 1.0 : 0.62) * strength);
    style.arrowSpacing = kArrowSpacing / strength;
    paintRoute(painter, id, selected && showsFullRoutes_, style);
  }
}

void RouteLayer::paintRobots(QPainter& painter) {
  for (const EntityId id : document().entities(EntityKind::Robot)) {
    const bool selected = document().isSelected(id);
    const Style style{theme().color(Role::RobotLine), selected ? 2.6 : 2.0, Qt::CustomDashLine};
    paintRoute(painter, id, true, style);
  }
}

void RouteLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) {
  painter->setRenderHint(QPainter::Antialiasing);
  exposed_ = option->exposedRect;
  std::size_t chosen = 0;
  std::size_t legs = 0;
  for (const EntityId id : document().selection()) {
    const EntityRoute* route =
        id.kind == EntityKind::Human ? mapScene().routes().route(id) : nullptr;
    chosen += route != nullptr ? 1 : 0;
    legs += route != nullptr ? route->size() : 0;
  }
  showsFullRoutes_ = legs <= kMaxLegs;
  selectedOpacity_ =
      std::max(kFaintestChosen, routeOpacity(showsFullRoutes_ ? legs / kLegsPerRoute : chosen));
  opacity_ = routeOpacity(countVisibleRoutes(shownRect(*painter, *option, widget)));
  if (options().routes) {
    paintPeople(*painter, false);
    paintRobots(*painter);
  }
  paintPeople(*painter, true);
}

}  // namespace editor
