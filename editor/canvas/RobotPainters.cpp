#include "editor/canvas/RobotPainters.h"

#include <array>
#include <cmath>
#include <numeric>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/PixelFrame.h"
#include "sim2d/base/Math.h"

namespace editor {

namespace {

constexpr double kMinLocalizationError = 0.05;              // [m]
constexpr double kMinHeadingError = 2.0 * base::kPi / 180;  // [rad]
constexpr double kArrowSeconds = 0.5;                       // Duration of a velocity arrow [s].
constexpr double kWeakest = 0.1, kStrongest = 0.5;          // Opacity of other trajectories.

constexpr double kFarTrack = 0.25;       // A farther track is apart from its body [m].
constexpr std::size_t kMaxBeams = 1200;  // Larger scans are thinned out.
constexpr double kUsualShare = 0.9;      // Share of the trajectories within the colour scale.
constexpr int kFreeCost = 0, kNearCost = 252, kTouchCost = 253, kObstacleCost = 254;
constexpr int kArcParts = 24;
constexpr double kAimPx = 6.0;

/// A long-dashed pen in the colour of robot perception.
QPen perceptionPen(const QPainter& painter, const Theme& theme, double widthPx) {
  return cosmetic(dashedPen(theme.color(Role::Lidar), widthPx, {3.0, 2.0}), painter);
}

void paintLine(QPainter& painter, const std::vector<Vec2>& points, const QPen& pen) {
  setPenAndBrush(painter, cosmetic(pen, painter));
  painter.drawPolyline(toScene(points));
}

QPen roundPen(const QColor& color, double width) {
  return QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
}

bool hasPlannerData(const sim2d::RobotTelemetry& senses) {
  return senses.localCosts != nullptr || senses.globalCosts != nullptr || hasCostTerms(senses) ||
         !senses.lookahead.empty() || !senses.masks.empty();
}

/// The indices of trajectories by ascending or descending cost.
std::vector<std::size_t> orderByCost(const std::vector<sim2d::RobotTelemetry::Candidate>& ways,
                                     bool isAscending) {
  std::vector<std::size_t> order(ways.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return isAscending ? ways[a].cost < ways[b].cost : ways[a].cost > ways[b].cost;
  });
  return order;
}

/// The perception of all robots of the shown frame, with their ids.
template <class Visit>
void forEachSenses(const MapScene& scene, Visit visit) {
  const sim2d::Frame* frame = scene.frameLayer().frame();
  if (frame == nullptr || frame->senses == nullptr) {
    return;
  }
  for (std::size_t i = 0; i < std::min(frame->robots.size(), frame->senses->size()); ++i) {
    visit(frame->robots.id[i], (*frame->senses)[i]);
  }
}

void paintCandidatesByRank(QPainter& painter, const Theme& theme,
                           const std::vector<sim2d::RobotTelemetry::Candidate>& ways) {
  const std::vector<double> relativeCost = relativeCosts(ways);
  for (const bool isChosenTurn : {false, true}) {  // The chosen trajectory is drawn last.
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (ways[i].isChosen == isChosenTurn) {
        const double alpha = kStrongest + (kWeakest - kStrongest) * relativeCost[i];
        const QColor color = isChosenTurn ? theme.color(Role::Accent)
                             : std::isfinite(ways[i].cost)
                                 ? theme.color(Role::Accent, alpha)
                                 : theme.color(Role::Error, kWeakest + 0.15);
        paintLine(painter, ways[i].points, roundPen(color, isChosenTurn ? 2.5 : 1.0));
      }
    }
  }
}

void paintCandidatesByCost(QPainter& painter, const Theme& theme,
                           const std::vector<sim2d::RobotTelemetry::Candidate>& ways) {
  const CostScale scale = costScaleOf(ways);
  for (const std::size_t i : orderByCost(ways, false)) {
    if (!ways[i].isChosen) {
      const QColor color =
          std::isfinite(ways[i].cost)
              ? withAlpha(trajectoryCostColor(theme, costShare(scale, ways[i].cost)), 0.75)
              : theme.color(Role::TextSecondary, 0.3);
      paintLine(painter, ways[i].points, roundPen(color, 1.0));
    }
  }
  for (const sim2d::RobotTelemetry::Candidate& way : ways) {
    if (way.isChosen) {
      paintLine(painter, way.points, roundPen(theme.color(Role::MapFree, 0.9), 5.0));
      paintLine(painter, way.points, roundPen(theme.color(Role::Text), 2.5));
    }
  }
}

/// Draws the lookahead point, the arc to it, and the goal.
void paintAim(QPainter& painter, const Theme& theme, const sim2d::RobotTelemetry& senses) {
  const QColor color = theme.color(Role::Accent);
  if (senses.ways.empty() && !senses.lookahead.empty()) {
    paintLine(painter, pursuitArc(senses.believed, senses.lookahead.front()),
              QPen(color, 2.0, Qt::SolidLine, Qt::RoundCap));
  }
  if (senses.ways.empty() && senses.predicted.size() > 1) {
    paintLine(painter, senses.predicted, dashedPen(theme.color(Role::Text), 2.0, {3.0, 2.0}));
  }
  for (const Vec2& point : senses.lookahead) {
    const PixelFrame frame(painter, toScene(point));
    paintRing(painter, QPen(theme.color(Role::MapFree), 4.5), kAimPx);
    paintRing(painter, QPen(color, 2.0), kAimPx);
    setPenAndBrush(painter, Qt::NoPen, color);
    painter.drawEllipse(QPointF(), 1.8, 1.8);
  }
}

}  // namespace

bool isBeamHit(const sim2d::RobotTelemetry::Scan& scan, std::size_t beam) {
  return scan.distances[beam] < scan.range;
}

Vec2 beamEnd(const sim2d::RobotTelemetry::Scan& scan, std::size_t beam) {
  const double angle =
      scan.sensor.heading + scan.angleMin + static_cast<double>(beam) * scan.angleIncrement;
  return Pose2{scan.sensor.position, angle}.ahead(scan.distances[beam]);
}

std::optional<Pose2> divergentPoseEstimate(const sim2d::Frame& frame, std::size_t robot) {
  const sim2d::RobotTelemetry& senses = (*frame.senses)[robot];
  if ((senses.bodies.empty() && senses.ways.empty() && !senses.scan) || frame.step == 0) {
    return std::nullopt;
  }
  const double dt = frame.time / static_cast<double>(frame.step);
  const sim2d::RobotColumns& robots = frame.robots;
  const Vec2 before(robots.x[robot] - dt * robots.vx[robot],
                    robots.y[robot] - dt * robots.vy[robot]);
  const double heading = robots.heading[robot] - dt * robots.omega[robot];
  const bool isThere =
      (senses.believed.position - before).norm() < kMinLocalizationError &&
      std::abs(base::angleDiff(senses.believed.heading, heading)) < kMinHeadingError;
  return isThere ? std::nullopt : std::optional(senses.believed);
}

std::vector<double> relativeCosts(const std::vector<sim2d::RobotTelemetry::Candidate>& ways) {
  const std::vector<std::size_t> order = orderByCost(ways, true);
  const auto open = std::count_if(ways.begin(), ways.end(),
                                  [](const auto& way) { return std::isfinite(way.cost); });
  std::vector<double> relativeCost(ways.size(), 1.0);
  for (std::size_t place = 0; place + 1 < static_cast<std::size_t>(open); ++place) {
    relativeCost[order[place]] = static_cast<double>(place) / static_cast<double>(open - 1);
  }
  if (open == 1) {
    relativeCost[order.front()] = 0.0;
  }
  return relativeCost;
}

void paintScan(QPainter& painter, const Theme& theme, const sim2d::RobotTelemetry::Scan& scan) {
  const std::size_t stride = 1 + scan.distances.size() / kMaxBeams;
  QPolygonF seen;
  QPolygonF hits;
  seen << toScene(scan.sensor.position);
  for (std::size_t beam = 0; beam < scan.distances.size(); beam += stride) {
    const QPointF end = toScene(beamEnd(scan, beam));
    seen << end;
    if (isBeamHit(scan, beam)) {
      hits << end;
    }
  }
  setPenAndBrush(painter, Qt::NoPen, theme.color(Role::Lidar, theme.isDark() ? 0.05 : 0.07));
  painter.drawPolygon(seen);
  painter.setPen(
      cosmetic(QPen(theme.color(Role::Lidar), 3.0, Qt::SolidLine, Qt::RoundCap), painter));
  painter.drawPoints(hits);
}

void paintCandidates(QPainter& painter, const Theme& theme, const sim2d::RobotTelemetry& senses) {
  hasCostTerms(senses) ? paintCandidatesByCost(painter, theme, senses.ways)
                       : paintCandidatesByRank(painter, theme, senses.ways);
  paintAim(painter, theme, senses);
}

void paintTracks(
    QPainter& painter, const Theme& theme, const std::vector<sim2d::RobotTelemetry::Body>& bodies,
    const std::function<std::optional<Vec2>(const sim2d::RobotTelemetry::Body&)>& place) {
  for (const sim2d::RobotTelemetry::Body& body : bodies) {
    const QPointF at = toScene(body.position);
    const double radius = body.radius + kTrackGap;
    setPenAndBrush(painter, perceptionPen(painter, theme, 1.8));
    painter.drawEllipse(at, radius, radius);
    const std::optional<Vec2> truth = place(body);
    if (truth && (*truth - body.position).norm() > kFarTrack) {
      painter.drawLine(at, toScene(*truth));
    }
    if (body.velocity.norm() > 0.05) {
      const Vec2 ahead = body.velocity.normalized();
      const Vec2 tip = body.position + radius * ahead + kArrowSeconds * body.velocity;
      setPenAndBrush(painter, screenPen(painter, theme.color(Role::Lidar), 1.8));
      painter.drawLine(toScene(body.position + radius * ahead), toScene(tip));
    }
  }
}

void paintLocalizationError(QPainter& painter, const Theme& theme, const Vec2& from,
                            const Vec2& believed) {
  setPenAndBrush(painter, perceptionPen(painter, theme, 1.5));
  painter.drawLine(toScene(from), toScene(believed));
}

CostScale costScaleOf(const std::vector<sim2d::RobotTelemetry::Candidate>& ways) {
  CostScale scale;
  std::vector<double> open;
  for (const sim2d::RobotTelemetry::Candidate& way : ways) {
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

double costShare(const CostScale& scale, double cost) {
  return scale.high > scale.low
             ? std::clamp((cost - scale.low) / (scale.high - scale.low), 0.0, 1.0)
             : 0.0;
}

QColor trajectoryCostColor(const Theme& theme, double share) {
  const std::array<QColor, 3> marks = theme.isDark()
                                          ? std::array<QColor, 3>{"#3C93D6", "#B98AB5", "#EE7A26"}
                                          : std::array<QColor, 3>{"#0072B2", "#9C5C8F", "#C65600"};
  return share < 0.5 ? mixed(marks[0], marks[1], 2.0 * share)
                     : mixed(marks[1], marks[2], 2.0 * share - 1.0);
}

QColor costColor(const Theme& theme, std::uint8_t cost) {
  if (cost == kFreeCost) {
    return Qt::transparent;
  }
  const bool isDark = theme.isDark();
  const QColor ramp(isDark ? "#B98AE0" : "#7B3FA0");
  return cost <= kNearCost ? withAlpha(ramp, 0.06 + 0.34 * (static_cast<double>(cost) / kNearCost))
         : cost == kTouchCost    ? withAlpha(ramp, 0.62)
         : cost == kObstacleCost ? withAlpha(QColor(isDark ? "#F2C4FF" : "#4A1466"), 0.9)
                                 : withAlpha(QColor(isDark ? "#9AA4AE" : "#5F6B76"), 0.22);
}

QColor maskColor(const Theme& theme, sim2d::MaskGrid::Kind kind, std::uint8_t percent) {
  if (percent == 0) {
    return Qt::transparent;
  }
  const double share = std::min(0.01 * percent, 1.0);
  switch (kind) {
    case sim2d::MaskGrid::Kind::Keepout:
      return theme.color(Role::Error, 0.10 + 0.30 * share);
    case sim2d::MaskGrid::Kind::Speed:
      return theme.color(Role::WarningMark, 0.50 - 0.38 * share);
    case sim2d::MaskGrid::Kind::Switch:
      break;
  }
  return theme.color(Role::Accent, 0.25);
}

namespace {

/// `colorOf`: the colour of a value.
template <class ColorOf>
QImage gridImage(const sim2d::CostGrid& grid, const ColorOf& colorOf) {
  std::array<QRgb, 256> colors{};
  for (std::size_t cost = 0; cost < colors.size(); ++cost) {
    colors.at(cost) = qPremultiply(colorOf(static_cast<std::uint8_t>(cost)).rgba());
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

}  // namespace

QImage costImage(const sim2d::CostGrid& grid, const Theme& theme) {
  return gridImage(grid, [&](std::uint8_t cost) { return costColor(theme, cost); });
}

QImage maskImage(const sim2d::MaskGrid& mask, const Theme& theme) {
  return gridImage(*mask.grid,
                   [&](std::uint8_t percent) { return maskColor(theme, mask.kind, percent); });
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
  const double turn = 2.0 * base::atan2(y, x);  // Angle of the whole arc [rad].
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

bool hasCostTerms(const sim2d::RobotTelemetry& senses) {
  return std::any_of(senses.ways.begin(), senses.ways.end(),
                     [](const auto& way) { return !way.scores.empty(); });
}

std::optional<ObservedRobot> selectedRobot(const MapScene& scene) {
  std::optional<ObservedRobot> found;
  const std::vector<EntityId>& selection = scene.document().selection();
  const FrameLayer& layer = scene.frameLayer();
  forEachSenses(scene, [&](int id, const sim2d::RobotTelemetry& senses) {
    if (!found && selection.size() == 1 && layer.entityOf(id) == selection.front()) {
      found = ObservedRobot{&senses, layer.nameOf(id)};
    }
  });
  return found;
}

std::optional<ObservedRobot> observedPlanner(const MapScene& scene) {
  std::optional<ObservedRobot> found = selectedRobot(scene);
  forEachSenses(scene, [&](int id, const sim2d::RobotTelemetry& senses) {
    if (!found && hasPlannerData(senses)) {
      found = ObservedRobot{&senses, scene.frameLayer().nameOf(id)};
    }
  });
  return found;
}

void paintCells(QPainter& painter, const sim2d::CostGrid& grid, const QImage& image,
                const QRectF& hole) {
  painter.save();
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  const QRectF area = areaOf(grid);
  if (!hole.isEmpty()) {
    QPainterPath around;
    around.addRect(area);
    around.addRect(hole & area);
    painter.setClipPath(around, Qt::IntersectClip);
  }
  painter.drawImage(area, image);
  painter.restore();
}

void paintCostEdge(QPainter& painter, const Theme& theme, const sim2d::CostGrid& grid) {
  setPenAndBrush(painter,
                 cosmetic(dashedPen(costColor(theme, kTouchCost), 1.2, {4.0, 3.0}), painter));
  painter.drawRect(areaOf(grid));
}

}  // namespace editor
