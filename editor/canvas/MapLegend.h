#pragma once

#include <functional>
#include <vector>

#include <QWidget>

#include "editor/canvas/MapScene.h"

namespace editor {

class MapView;

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

LegendRow noteRow(const QString& label);
/// A horizontal line.
LegendSample strokeSample(const QPen& pen);
/// A colour bar, wider than the box. `colorOf`: the colour for a share of its length, 0 … 1.
LegendSample rampSample(const Theme& theme, const std::function<QColor(double)>& colorOf);

/// The legend of all active overlays; empty without a run. `pixelsPerMetre`: zoom of the view, for
/// arrow scales.
std::vector<LegendPart> legendOf(const MapScene& scene, double pixelsPerMetre);
/// Returns true if an active overlay has a legend, independently of the selection, to keep the
/// layout stable. Laser scans, which are on by default, count only while a robot with a lidar is
/// selected.
bool needsLegend(const MapScene& scene);
/// Cell costs of a planner's costmaps; costs of its candidate trajectories, and the score of each
/// critic for the chosen one (no rows if the planner does not report them).
LegendPart costPart(const MapScene& scene);
/// Effects of the masks of a planner's costmap filters.
LegendPart maskPart(const MapScene& scene);
LegendPart trajectoryCostPart(const MapScene& scene);
/// Lidar, detector and candidate trajectories of the single selected robot.
std::vector<LegendRow> senseRows(const MapScene& scene);
/// Returns true if a single robot with a lidar is selected in a run.
bool isLidarChosen(const MapScene& scene);

/// The legend at the right of a view. It does not cover the map: the view becomes narrower while
/// the legend is visible.
class LegendStrip : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kWidth = 196;  // [px]
  explicit LegendStrip(MapView& view);
  void setStateColor(const QColor& color);  // Colour of the state line at the top of the canvas.

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double paintPart(QPainter& painter, const LegendPart& part, const QRectF& room) const;

  MapView& view_;
  QColor state_;
};

}  // namespace editor
