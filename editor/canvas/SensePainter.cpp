#include "editor/canvas/SensePainter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <QPainter>

#include "editor/canvas/Layers.h"
#include "editor/canvas/PixelFrame.h"

namespace editor {

namespace {

constexpr double kSlip = 0.05;                         // [m]
constexpr double kTurnedAway = 2.0 * base::kPi / 180;  // [rad]
constexpr double kAhead = 0.5;                         // [s], the length of an arrow of velocity
constexpr double kWeakest = 0.1, kStrongest = 0.5;     // of ways that were not chosen

/// "far" as a dashed line in the colour of what robots perceive.
QPen dashed(const QPainter& painter, const QColor& color, double widthPx) {
  QPen pen(color, widthPx, Qt::CustomDashLine, Qt::FlatCap);
  pen.setDashPattern({3.0, 2.0});
  makeCosmetic(pen, painter);
  return pen;
}

}  // namespace

bool isHit(const sim2d::RobotSenses::Scan& scan, std::size_t beam) {
  return scan.distances[beam] < scan.range;
}

Vec2 endOf(const sim2d::RobotSenses::Scan& scan, std::size_t beam) {
  const double angle =
      scan.sensor.heading + scan.angleMin + static_cast<double>(beam) * scan.perBeam;
  return Pose2{scan.sensor.position, angle}.ahead(scan.distances[beam]);
}

std::optional<Pose2> believedElsewhere(const sim2d::Frame& frame, std::size_t robot) {
  const sim2d::RobotSenses& senses = (*frame.senses)[robot];
  if ((senses.bodies.empty() && senses.ways.empty() && !senses.scan) || frame.step == 0) {
    return std::nullopt;
  }
  const double dt = frame.time / static_cast<double>(frame.step);
  const sim2d::RobotColumns& robots = frame.robots;
  const Vec2 before(robots.x[robot] - dt * robots.vx[robot],
                    robots.y[robot] - dt * robots.vy[robot]);
  const double heading = robots.heading[robot] - dt * robots.omega[robot];
  const bool isThere = (senses.believed.position - before).norm() < kSlip &&
                       std::abs(base::angleDiff(senses.believed.heading, heading)) < kTurnedAway;
  return isThere ? std::nullopt : std::optional(senses.believed);
}

std::vector<double> dearnessOf(const std::vector<sim2d::RobotSenses::Way>& ways) {
  std::vector<std::size_t> order(ways.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return ways[a].cost < ways[b].cost; });
  const auto open = std::count_if(ways.begin(), ways.end(),
                                  [](const auto& way) { return std::isfinite(way.cost); });
  std::vector<double> dearness(ways.size(), 1.0);
  for (std::size_t place = 0; place + 1 < static_cast<std::size_t>(open); ++place) {
    dearness[order[place]] = static_cast<double>(place) / static_cast<double>(open - 1);
  }
  if (open == 1) {
    dearness[order.front()] = 0.0;
  }
  return dearness;
}

void SensePainter::scan(QPainter& painter, const sim2d::RobotSenses::Scan& scan) const {
  const std::size_t stride = 1 + scan.distances.size() / kMostBeams;
  QPolygonF seen;
  QPolygonF hits;
  seen << toScene(scan.sensor.position);
  for (std::size_t beam = 0; beam < scan.distances.size(); beam += stride) {
    const QPointF end = toScene(endOf(scan, beam));
    seen << end;
    if (isHit(scan, beam)) {
      hits << end;
    }
  }
  setInk(painter, Qt::NoPen, theme_.color(Role::Lidar, theme_.isDark() ? 0.05 : 0.07));
  painter.drawPolygon(seen);
  QPen dots(theme_.color(Role::Lidar), 3.0, Qt::SolidLine, Qt::RoundCap);
  makeCosmetic(dots, painter);
  painter.setPen(dots);
  painter.drawPoints(hits);
}

void SensePainter::ways(QPainter& painter, const std::vector<sim2d::RobotSenses::Way>& ways) const {
  const std::vector<double> dearness = dearnessOf(ways);
  for (const bool isChosenTurn : {false, true}) {  // the chosen one over the others
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (ways[i].isChosen != isChosenTurn) {
        continue;
      }
      const double alpha = kStrongest + (kWeakest - kStrongest) * dearness[i];
      const QColor color = ways[i].isChosen ? theme_.color(Role::Accent)
                           : std::isfinite(ways[i].cost)
                               ? theme_.color(Role::Accent, alpha)
                               : theme_.color(Role::Error, kWeakest + 0.15);
      QPen pen(color, ways[i].isChosen ? 2.5 : 1.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
      makeCosmetic(pen, painter);
      setInk(painter, pen);
      painter.drawPolyline(toScene(ways[i].points));
    }
  }
}

void SensePainter::tracks(QPainter& painter, const std::vector<sim2d::RobotSenses::Body>& bodies,
                          const Place& place) const {
  const QColor color = theme_.color(Role::Lidar);
  for (const sim2d::RobotSenses::Body& body : bodies) {
    const QPointF at = toScene(body.position);
    const double radius = body.radius + kTrackGap;
    setInk(painter, dashed(painter, color, 1.8));
    painter.drawEllipse(at, radius, radius);
    const std::optional<Vec2> truth = place(body);
    if (truth && (*truth - body.position).norm() > kFarTrack) {
      painter.drawLine(at, toScene(*truth));
    }
    if (body.velocity.norm() > 0.05) {
      const Vec2 ahead = body.velocity.normalized();
      const Vec2 tip = body.position + radius * ahead + kAhead * body.velocity;
      setInk(painter, screenPen(painter, color, 1.8));
      painter.drawLine(toScene(body.position + radius * ahead), toScene(tip));
    }
  }
}

void SensePainter::slip(QPainter& painter, const Vec2& from, const Vec2& believed) const {
  setInk(painter, dashed(painter, theme_.color(Role::Lidar), 1.5));
  painter.drawLine(toScene(from), toScene(believed));
}

}  // namespace editor
