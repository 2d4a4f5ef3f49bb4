#pragma once

#include <QGraphicsItem>
#include <QPainterPath>

#include "editor/canvas/MapScene.h"
#include "editor/canvas/RouteModel.h"

namespace editor {

/// All routes beneath the figures: of everybody the way to the first goal, of the selected ones the
/// whole round.
class RouteLayer : public QGraphicsItem {
 public:
  explicit RouteLayer(const MapScene& scene);
  void routesChanged();

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  struct Style {
    QColor color;
    double widthPx = 1.8;
    Qt::PenStyle dashes = Qt::SolidLine;
  };
  void paintRoute(QPainter& painter, EntityId id, bool whole, const Style& style) const;
  void paintLeg(QPainter& painter, const RouteLeg& leg, const Style& style) const;
  void paintPeople(QPainter& painter, bool selected) const;
  void paintRobots(QPainter& painter) const;

  const MapScene& scene_;
  QRectF bounds_;
};

/// A line with soft corners that stays within `softness` [m] of them.
QPainterPath softPath(const std::vector<Vec2>& points, double softness);
/// Chevrons along a path every `spacing` [m], the first one after half of it.
void paintArrowHeads(QPainter& painter, const QPainterPath& scenePath, double spacing,
                     double sizePx, const Theme& theme);

}  // namespace editor
