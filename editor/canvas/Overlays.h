#pragma once

#include <QPainter>

#include "editor/canvas/MapScene.h"

namespace editor {

/// What the view draws over the scene, in window pixels.
struct OverlayContext {
  const MapScene& scene;
  QRectF window;
  QTransform windowFromScene;
  double pixelsPerMetre = 50.0;
  int legendCorner = 0;  // in which the legend of groups stood last
};

constexpr int kRulerPx = 20;     // width of a ruler
constexpr int kStateLinePx = 3;  // height of the line on top of the canvas

void paintScaleBar(QPainter& painter, const OverlayContext& context);
void paintRulers(QPainter& painter, const OverlayContext& context);

/// Ring, name and number of people of each group, in a corner where nobody stands; none without
/// groups. Gives the corner, which it leaves only when somebody comes there.
int paintGroupLegend(QPainter& painter, const OverlayContext& context);
/// Where that is [px]; empty when there is no legend.
QRectF groupLegendBox(const OverlayContext& context);
/// The ground of a legend or of fields over the map.
void paintPlate(QPainter& painter, const Theme& theme, const QRectF& box);

/// What scale bar and rulers cover, where they are shown [px of the window].
std::vector<QRectF> overlayBoxes(const OverlayContext& context);

/// 1, 2 or 5 times a power of ten [m], about `targetPx` long on the screen.
double niceLength(double pixelsPerMetre, double targetPx);
/// The multiples of `step` from `low` to `high`.
std::vector<double> multiplesIn(double low, double high, double step);

}  // namespace editor
