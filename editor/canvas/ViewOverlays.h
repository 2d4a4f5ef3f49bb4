#pragma once

#include "editor/canvas/MapScene.h"

namespace editor {

/// The context of the overlays that the view draws over the scene, in window pixels.
struct OverlayContext {
  const MapScene& scene;
  QRectF window;
  QTransform windowFromScene;
  double pixelsPerMetre = 50.0;
  int legendCorner = 0;  // Previous corner of the group legend.
};

constexpr int kRulerPx = 20;     // Width of a ruler.
constexpr int kStateLinePx = 3;  // Height of the state line at the top of the canvas.

void paintScaleBar(QPainter& painter, const OverlayContext& context);
void paintRulers(QPainter& painter, const OverlayContext& context);

/// Draws ring, name and size of each group in a corner without people; nothing without groups.
/// Returns the corner, which changes only if people enter it.
int paintGroupLegend(QPainter& painter, const OverlayContext& context);
/// Rectangle of that legend [px]; empty if there is none.
QRectF groupLegendBox(const OverlayContext& context);
/// Draws the background of a legend or of fields over the map.
void paintLegendBackground(QPainter& painter, const Theme& theme, const QRectF& box);

/// The areas covered by scale bar and rulers, if shown [window px].
std::vector<QRectF> overlayRects(const OverlayContext& context);

/// 1, 2 or 5 times a power of ten [m], about `targetPx` long on the screen.
double niceLength(double pixelsPerMetre, double targetPx);
/// The multiples of `step` from `low` to `high`.
std::vector<double> multiplesIn(double low, double high, double step);

}  // namespace editor
