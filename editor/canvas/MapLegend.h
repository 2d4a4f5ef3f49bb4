#pragma once

#include <functional>

#include "editor/canvas/MapScene.h"

namespace editor {

constexpr double kLegendRowPx = 20.0;
constexpr int kRampPx = 118;  // Width of a colour bar.

/// Draws the sample of a legend entry in a box of 20 x 20 px.
using LegendSample = std::function<void(QPainter&, const QRectF&)>;

/// A legend entry for colours or signs of the run overlays.
struct LegendRow {
  QString label, value;  // Value text on the right with tabular digits.
  LegendSample sample;   // None: the text starts at the left.
  bool isNote = false;   // In a softer colour, for missing information.
};
struct LegendPart {
  QString title;
  std::vector<LegendRow> rows;
};

/// The legend of all active overlays; empty without a run. `pixelsPerMetre`: zoom of the view, for
/// arrow scales.
std::vector<LegendPart> legendOf(const MapScene& scene, double pixelsPerMetre);
/// Lidar, detector and candidate trajectories of the single selected robot.
std::vector<LegendRow> senseRows(const MapScene& scene);

}  // namespace editor
