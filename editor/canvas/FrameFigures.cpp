#include <algorithm>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/RouteLayer.h"

// The figures of a frame.
namespace editor {

void FrameLayer::paintPeople(QPainter& painter) {
  const double pixelsPerMetre = pixelsPerMetreOf(painter);
  std::vector<std::pair<QPointF, PersonFigure>> figures;
  figures.reserve(frame_->humans.size());
  const PixelFrame frame(painter, {});
  for (std::size_t i = 0; i < frame_->humans.size(); ++i) {
    const QPointF at =
        MapScene::sceneFromWorld(Vec2(frame_->humans.x[i], frame_->humans.y[i])) * pixelsPerMetre;
    figures.emplace_back(at, figureOf(i, pixelsPerMetre));
    if (isChosen(frame_->humans.id[i])) {
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(scene_.theme().color(Role::Accent), 2.0));
      const double ring = figures.back().second.radiusPx + 4.0;
      painter.drawEllipse(at, ring, ring);
    }
  }
  atlas_.draw(painter, scene_.theme(), figures);
}

void FrameLayer::paintRobots(QPainter& painter) const {
  const double pixelsPerMetre = pixelsPerMetreOf(painter);
  for (std::size_t i = 0; i < frame_->robots.size(); ++i) {
    const Agent& robot = agent(frame_->robots.id[i]);
    const double scale = std::max(pixelsPerMetre, kLeastFigurePx / robot.radius);
    RobotFigure figure;
    figure.radiusPx = robot.radius * scale;
    figure.headingDeg = frame_->robots.heading[i] * 180.0 / base::kPi;
    for (const base::Vec2& point : robot.footprint) {
      figure.footprintPx.emplace_back(point.x() * scale, point.y() * scale);
    }
    const PixelFrame frame(
        painter, MapScene::sceneFromWorld(Vec2(frame_->robots.x[i], frame_->robots.y[i])));
    if (isChosen(frame_->robots.id[i])) {
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(scene_.theme().color(Role::Accent), 2.0));
      painter.drawEllipse(QPointF(), figure.radiusPx + 5.0, figure.radiusPx + 5.0);
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
      const PixelFrame frame(painter, MapScene::sceneFromWorld(*robot.goal.point));
      paintRobotGoal(painter, scene_.theme());
    }
  }
}

}  // namespace editor
