#pragma once

#include <map>
#include <utility>
#include <vector>

#include <QGraphicsItem>
#include <QPainterPath>

#include "editor/canvas/MapScene.h"
#include "editor/canvas/RouteModel.h"

namespace editor {

/// How strong the ways of those are who are not selected, where so many are in sight: 1 for a few,
/// less the more there are, never nothing.
double routeStrength(std::size_t inSight);

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
    double arrowSpacing = 1.5;  // [m]
  };
  /// A leg ready to be painted.
  struct Line {
    std::vector<Vec2> points;
    QPainterPath path;                              // scene
    QRectF bounds;                                  // of the path
    double gap = 0.0;                               // between arrow heads [m]
    std::vector<std::pair<QPointF, double>> heads;  // tips, degrees
  };
  Line& lineOf(EntityId id, std::size_t index, const RouteLeg& leg);
  static void placeHeads(Line& line, double spacing, double pixelsPerMetre);
  std::size_t countInSight(const QRectF& shown);
  void paintRoute(QPainter& painter, EntityId id, bool whole, const Style& style);
  void paintLeg(QPainter& painter, const Line& line, bool isReachable, const Style& style) const;
  void paintPeople(QPainter& painter, bool selected);
  void paintRobots(QPainter& painter);

  const MapScene& scene_;
  QRectF bounds_;
  QRectF exposed_;               // of the current painting
  double strength_ = 1.0;        // of the ways of those who are not selected
  double chosenStrength_ = 1.0;  // and of those who are
  bool showsRounds_ = true;      // of those who are selected; else the way to the first goal
  std::map<EntityId, std::vector<Line>> lines_;
};

/// A line with soft corners that stays within `softness` [m] of them.
QPainterPath softPath(const std::vector<Vec2>& points, double softness);
/// Chevrons along a path every `spacing` [m], the first one after half of it.
void paintArrowHeads(QPainter& painter, const QPainterPath& scenePath, double spacing,
                     double sizePx, const Theme& theme);

}  // namespace editor
