#include "editor/canvas/PlannerPainter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/Layers.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/look/Images.h"
#include "sim2d/base/Math.h"

namespace editor {

namespace {

constexpr double kUsualShare = 0.9;  // of the ways, up to which prices have their own colours
constexpr int kFreeCost = 0, kNearCost = 252, kTouchCost = 253, kObstacleCost = 254;
constexpr int kArcParts = 24;
constexpr double kAimPx = 6.0;

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto part = [share](double from, double to) { return from + share * (to - from); };
  return QColor::fromRgbF(part(a.redF(), b.redF()), part(a.greenF(), b.greenF()),
                          part(a.blueF(), b.blueF()), part(a.alphaF(), b.alphaF()));
}

QColor shaded(const char* name, double alpha) {
  QColor color(name);
  color.setAlphaF(alpha);
  return color;
}

bool tellsOfPlanner(const sim2d::RobotSenses& senses) {
  return senses.localCosts != nullptr || senses.globalCosts != nullptr || hasPrices(senses) ||
         !senses.lookahead.empty();
}

}  // namespace

PriceScale priceScaleOf(const std::vector<sim2d::RobotSenses::Way>& ways) {
  PriceScale scale;
  std::vector<double> open;
  for (const sim2d::RobotSenses::Way& way : ways) {
    std::isfinite(way.cost) ? open.push_back(way.cost) : void(++scale.refused);
  }
  scale.open = open.size();
  if (open.empty()) {
    return scale;
  }
  std::sort(open.begin(), open.end());
  scale.low = open.front();
  const double last = static_cast<double>(open.size() - 1);
  scale.high = open[static_cast<std::size_t>(std::ceil(kUsualShare * last))];
  return scale;
}

double priceShare(const PriceScale& scale, double cost) {
  return scale.high > scale.low
             ? std::clamp((cost - scale.low) / (scale.high - scale.low), 0.0, 1.0)
             : 0.0;
}

QColor priceColor(const Theme& theme, double share) {
  const std::array<QColor, 3> marks = theme.isDark()
                                          ? std::array<QColor, 3>{"#3C93D6", "#B98AB5", "#EE7A26"}
                                          : std::array<QColor, 3>{"#0072B2", "#9C5C8F", "#C65600"};
  return share < 0.5 ? mixed(marks[0], marks[1], 2.0 * share)
                     : mixed(marks[1], marks[2], 2.0 * share - 1.0);
}

QColor costColor(const Theme& theme, std::uint8_t cost) {
  const bool isDark = theme.isDark();
  if (cost == kFreeCost) {
    return Qt::transparent;
  }
  if (cost <= kNearCost) {
    const double share = static_cast<double>(cost) / kNearCost;
    return shaded(isDark ? "#B98AE0" : "#7B3FA0", 0.06 + 0.34 * share);
  }
  if (cost == kTouchCost) {
    return shaded(isDark ? "#B98AE0" : "#7B3FA0", 0.62);
  }
  return cost == kObstacleCost ? shaded(isDark ? "#F2C4FF" : "#4A1466", 0.9)
                               : shaded(isDark ? "#9AA4AE" : "#5F6B76", 0.22);
}

QImage costImage(const sim2d::CostGrid& grid, const Theme& theme) {
  std::array<QRgb, 256> colors{};
  for (std::size_t cost = 0; cost < colors.size(); ++cost) {
    colors.at(cost) = qPremultiply(costColor(theme, static_cast<std::uint8_t>(cost)).rgba());
  }
  QImage image = blankImage({grid.columns, grid.rows}, QImage::Format_ARGB32_Premultiplied);
  for (int row = 0; row < grid.rows; ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(grid.rows - 1 - row));
    const std::size_t first =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns);
    for (int column = 0; column < grid.columns; ++column) {
      line[column] = colors.at(grid.costs[first + static_cast<std::size_t>(column)]);
    }
  }
  return image;
}

QRectF areaOf(const sim2d::CostGrid& grid) {
  const Vec2 high = grid.origin + grid.resolution * Vec2(grid.columns, grid.rows);
  return QRectF(toScene(grid.origin), toScene(high)).normalized();
}

std::vector<Vec2> pursuitArc(const Pose2& robot, const Vec2& target) {
  const Vec2 to = target - robot.position;
  const Vec2 ahead = robot.direction();
  const double x = to.dot(ahead);
  const double y = ahead.x() * to.y() - ahead.y() * to.x();
  const double turn = 2.0 * base::atan2(y, x);  // [rad], over the whole arc
  if (std::abs(y) < 1e-6 || std::abs(turn) > 1.9 * base::kPi) {
    return {robot.position, target};
  }
  const double radius = to.squaredNorm() / (2.0 * y);
  std::vector<Vec2> points;
  for (int k = 0; k <= kArcParts; ++k) {
    const double part = turn * k / kArcParts;
    const double along = radius * base::sin(part);
    const double across = radius * (1.0 - base::cos(part));
    points.push_back(robot.position + along * ahead + across * Vec2(-ahead.y(), ahead.x()));
  }
  return points;
}

bool hasPrices(const sim2d::RobotSenses& senses) {
  return std::any_of(senses.ways.begin(), senses.ways.end(),
                     [](const auto& way) { return !way.scores.empty(); });
}

std::optional<LookedAt> plannerLookedAt(const MapScene& scene) {
  const FrameLayer& layer = scene.frameLayer();
  const sim2d::Frame* frame = layer.frame();
  if (frame == nullptr || frame->senses == nullptr) {
    return std::nullopt;
  }
  std::optional<LookedAt> first;
  const std::vector<EntityId>& selection = scene.document().selection();
  for (std::size_t i = 0; i < std::min(frame->robots.size(), frame->senses->size()); ++i) {
    const LookedAt robot{&(*frame->senses)[i], layer.nameOf(frame->robots.id[i])};
    if (selection.size() == 1 && layer.entityOf(frame->robots.id[i]) == selection.front()) {
      return robot;
    }
    if (!first && tellsOfPlanner(*robot.senses)) {
      first = robot;
    }
  }
  return first;
}

void PlannerPainter::costs(QPainter& painter, const sim2d::CostGrid& grid, const QImage& image,
                           const QRectF& hole) const {
  painter.save();
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  const QRectF area = areaOf(grid);
  if (hole.isEmpty()) {
    painter.drawImage(area, image);
  } else {
    QPainterPath around;
    around.addRect(area);
    around.addRect(hole & area);
    painter.setClipPath(around, Qt::IntersectClip);
    painter.drawImage(area, image);
  }
  painter.restore();
}

void PlannerPainter::edge(QPainter& painter, const sim2d::CostGrid& grid) const {
  QPen pen(costColor(theme_, kTouchCost), 1.2, Qt::CustomDashLine, Qt::FlatCap);
  pen.setDashPattern({4.0, 3.0});
  makeCosmetic(pen, painter);
  setInk(painter, pen);
  painter.drawRect(areaOf(grid));
}

void PlannerPainter::line(QPainter& painter, const std::vector<Vec2>& points,
                          const QPen& pen) const {
  QPen ink = pen;
  makeCosmetic(ink, painter);
  setInk(painter, ink);
  painter.drawPolyline(toScene(points));
}

void PlannerPainter::ways(QPainter& painter,
                          const std::vector<sim2d::RobotSenses::Way>& ways) const {
  const PriceScale scale = priceScaleOf(ways);
  std::vector<std::size_t> order(ways.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return ways[a].cost > ways[b].cost; });
  const auto pen = [](const QColor& color, double width) {
    return QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  };
  for (const std::size_t i : order) {
    if (ways[i].isChosen) {
      continue;
    }
    const bool isOpen = std::isfinite(ways[i].cost);
    QColor color = isOpen ? priceColor(theme_, priceShare(scale, ways[i].cost))
                          : theme_.color(Role::TextSecondary, 0.3);
    color.setAlphaF(isOpen ? 0.75 : color.alphaF());
    line(painter, ways[i].points, pen(color, 1.0));
  }
  for (const sim2d::RobotSenses::Way& way : ways) {
    if (way.isChosen) {
      line(painter, way.points, pen(theme_.color(Role::MapFree, 0.9), 5.0));
      line(painter, way.points, pen(theme_.color(Role::Text), 2.5));
    }
  }
}

void PlannerPainter::aim(QPainter& painter, const sim2d::RobotSenses& senses) const {
  const QColor color = theme_.color(Role::Accent);
  if (senses.ways.empty() && !senses.lookahead.empty()) {
    line(painter, pursuitArc(senses.believed, senses.lookahead.front()),
         QPen(color, 2.0, Qt::SolidLine, Qt::RoundCap));
  }
  if (senses.ways.empty() && senses.predicted.size() > 1) {
    QPen pen(theme_.color(Role::Text), 2.0, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({3.0, 2.0});
    line(painter, senses.predicted, pen);
  }
  for (const Vec2& point : senses.lookahead) {
    const PixelFrame frame(painter, toScene(point));
    paintRing(painter, QPen(theme_.color(Role::MapFree), 4.5), kAimPx);
    paintRing(painter, QPen(color, 2.0), kAimPx);
    setInk(painter, Qt::NoPen, color);
    painter.drawEllipse(QPointF(), 1.8, 1.8);
  }
}

}  // namespace editor
