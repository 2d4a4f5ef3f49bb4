#include <algorithm>
#include <cmath>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/RouteLayer.h"

// What FrameLayer paints: figures, trails, spaces, forces, speech.
namespace editor {

namespace {

constexpr double kSpeechSeconds = 4.0;
constexpr double kSpeechFade = 0.6;  // [s] at its end
constexpr int kTrailParts = 10;
constexpr double kBubbleWidthPx = 220.0;
constexpr int kBubbleText = int{Qt::TextWordWrap} | int{Qt::AlignCenter};

}  // namespace

void FrameLayer::paintPeople(QPainter& painter) {
  const double pixelsPerMetre = pixelsPerMetreOf(painter);
  std::vector<std::pair<QPointF, PersonFigure>> figures;
  figures.reserve(frame_->humans.size());
  const PixelFrame frame(painter, {});
  for (std::size_t i = 0; i < frame_->humans.size(); ++i) {
    const QPointF at = MapScene::sceneFromWorld(positionAt(frame_->humans, i)) * pixelsPerMetre;
    figures.emplace_back(at, figureOf(i, pixelsPerMetre));
    if (isChosen(frame_->humans.id[i])) {
      paintRing(painter, QPen(scene_.theme().color(Role::Accent), 2.0),
                figures.back().second.radiusPx + 4.0, at);
    }
  }
  atlas_.draw(painter, scene_.theme(), figures);
}

void FrameLayer::paintRobots(QPainter& painter) const {
  const double pixelsPerMetre = pixelsPerMetreOf(painter);
  for (std::size_t i = 0; i < frame_->robots.size(); ++i) {
    const Agent& robot = agent(frame_->robots.id[i]);
    const RobotFigure figure =
        robotFigure(robot.radius, robot.footprint, frame_->robots.heading[i], pixelsPerMetre);
    const PixelFrame frame(painter, MapScene::sceneFromWorld(positionAt(frame_->robots, i)));
    if (isChosen(frame_->robots.id[i])) {
      paintRing(painter, QPen(scene_.theme().color(Role::Accent), 2.0), figure.radiusPx + 5.0);
    }
    FigurePainter(scene_.theme()).robot(painter, figure);
  }
}

void FrameLayer::paintRobotPaths(QPainter& painter) const {
  QPen pen(scene_.theme().color(Role::RobotLine), 2.0, Qt::CustomDashLine, Qt::FlatCap);
  pen.setDashPattern({3.5, 2.5});
  makeCosmetic(pen, painter);
  painter.setBrush(Qt::NoBrush);
  for (const std::vector<base::Vec2>& points : frame_->robotPaths) {
    const QPainterPath path = softPath(points, 0.3);
    painter.setPen(pen);
    painter.drawPath(path);
    paintArrowHeads(painter, path, 1.5, 8.0, scene_.theme());
  }
  for (const sim2d::Robot& robot : scene_.document().scenario().robots) {
    if (robot.listed && robot.goal.point) {
      paintRobotGoal(painter, scene_.theme(), *robot.goal.point);
    }
  }
}

std::vector<ForceArrow> forcesOn(const sim2d::Frame& frame, int humanId) {
  const auto found = std::find(frame.humans.id.begin(), frame.humans.id.end(), humanId);
  const auto i = static_cast<std::size_t>(found - frame.humans.id.begin());
  const sim2d::ForceColumns& forces = frame.forces;
  const bool isComplete = i < forces.goal.size() && i < forces.social.size() &&
                          i < forces.obstacle.size() && i < forces.group.size();
  if (found == frame.humans.id.end() || !isComplete) {
    return {};
  }
  const base::Vec2 total = forces.goal[i] + forces.social[i] + forces.obstacle[i] + forces.group[i];
  return {{QStringLiteral("Goal"), Role::ForceGoal, forces.goal[i]},
          {QStringLiteral("People"), Role::ForceSocial, forces.social[i]},
          {QStringLiteral("Obstacles"), Role::ForceObstacle, forces.obstacle[i]},
          {QStringLiteral("Group"), Role::ForceGroup, forces.group[i]},
          {QStringLiteral("Total"), Role::ForceTotal, total}};
}

void FrameLayer::paintTrail(QPainter& painter, const Trail& trail, const QColor& color) const {
  const std::size_t count = trail.points.size();
  for (int part = 0; part < kTrailParts; ++part) {
    const std::size_t from = count * static_cast<std::size_t>(part) / kTrailParts;
    const std::size_t to =
        std::min(count - 1, count * static_cast<std::size_t>(part + 1) / kTrailParts);
    QPolygonF line;
    for (std::size_t i = from; i <= to; ++i) {
      line << MapScene::sceneFromWorld(trail.points[i].second);
    }
    QColor faded = color;
    faded.setAlphaF(0.5 * (part + 1) / kTrailParts);
    QPen pen(faded, 4.0, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    makeCosmetic(pen, painter);
    painter.setPen(pen);
    painter.drawPolyline(line);
  }
}

void FrameLayer::paintTrails(QPainter& painter) const {
  painter.setBrush(Qt::NoBrush);
  for (const auto& [id, trail] : trails_) {
    if (trail.points.size() > 1) {
      paintTrail(
          painter, trail,
          id < 0 ? scene_.theme().color(Role::RobotLine) : scene_.theme().line(agent(id).look));
    }
  }
}

void FrameLayer::paintForces(QPainter& painter) const {
  const double pixelsPerMetre = pixelsPerMetreOf(painter);
  for (std::size_t i = 0; i < frame_->humans.size(); ++i) {
    const int id = frame_->humans.id[i];
    if (!isChosen(id)) {
      continue;
    }
    const PixelFrame frame(painter, MapScene::sceneFromWorld(positionAt(frame_->humans, i)));
    const double ring = agent(id).radius * pixelsPerMetre + 7.0;
    for (const ForceArrow& arrow : forcesOn(*frame_, id)) {
      const double length = arrow.force.norm() * kMetresPerForce * pixelsPerMetre;
      if (length < 2.0) {
        continue;
      }
      const double heading = base::headingOf(arrow.force);
      const QPointF along(std::cos(heading), -std::sin(heading));
      const QPointF tip = (ring + length) * along;
      painter.setPen(QPen(scene_.theme().color(arrow.color), 2.2, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(ring * along, tip);
      FigurePainter(scene_.theme()).arrowHead(painter, tip, degrees(heading), 7.0);
    }
  }
}

void FrameLayer::paintBubble(QPainter& painter, const Speech& speech) const {
  const std::optional<base::Vec2> at = positionOf(speech.id);
  if (!at) {
    return;
  }
  const double left = speech.since + kSpeechSeconds - frame_->time;
  const double radiusPx = agent(speech.id).radius * pixelsPerMetreOf(painter);
  const PixelFrame frame(painter, MapScene::sceneFromWorld(*at));
  painter.setOpacity(std::clamp(left / kSpeechFade, 0.0, 1.0));
  const QFont font = scene_.theme().font(9.0);
  const QFontMetricsF metrics(font);
  const QRectF text =
      metrics.boundingRect(QRectF(0.0, 0.0, kBubbleWidthPx, 200.0), kBubbleText, speech.text);
  QRectF box(QPointF(), text.size() + QSizeF(20.0, 12.0));
  box.moveBottomLeft(QPointF(-14.0, -radiusPx - 12.0));
  QPainterPath bubble;
  bubble.addRoundedRect(box, 6.0, 6.0);
  QPainterPath tail;
  tail.addPolygon(QPolygonF({QPointF(-6.0, box.bottom() - 1.0), QPointF(8.0, box.bottom() - 1.0),
                             QPointF(0.0, -radiusPx - 3.0)}));
  tail.closeSubpath();
  painter.setPen(QPen(scene_.theme().color(Role::FieldEdge), 1.0));
  painter.setBrush(scene_.theme().isDark() ? scene_.theme().color(Role::Text)
                                           : scene_.theme().color(Role::Panel));
  painter.drawPath(bubble.united(tail));
  painter.setFont(font);
  painter.setPen(scene_.theme().isDark() ? scene_.theme().color(Role::Window)
                                         : scene_.theme().color(Role::Text));
  painter.drawText(box, kBubbleText, speech.text);
}

void FrameLayer::paintSpeech(QPainter& painter) const {
  std::map<int, const Speech*> latest;  // a person's newest words take the place of older ones
  for (const Speech& speech : speeches_) {
    if (speech.since <= frame_->time && frame_->time < speech.since + kSpeechSeconds) {
      latest[speech.id] = &speech;
    }
  }
  for (const auto& [id, speech] : latest) {
    paintBubble(painter, *speech);
  }
}

}  // namespace editor
