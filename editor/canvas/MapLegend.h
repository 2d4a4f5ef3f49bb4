#pragma once

#include <functional>

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

/// The legend of all active overlays; empty without a run. `pixelsPerMetre`: zoom of the view, for
/// arrow scales.
std::vector<LegendPart> legendOf(const MapScene& scene, double pixelsPerMetre);
/// Returns true if an active overlay has a legend, independently of the selection, to keep the
/// layout stable. Laser scans, which are on by default, count only while a robot with a lidar is
/// selected.
bool needsLegend(const MapScene& scene);
/// Lidar, detector and candidate trajectories of the single selected robot.
std::vector<LegendRow> senseRows(const MapScene& scene);

/// The legend at the right of a view. It does not cover the map: the view becomes narrower while
/// the legend is visible.
class LegendStrip : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kWidth = 196;  // [px]
  explicit LegendStrip(MapView& view);
  /// Colour of the state line at the top of the canvas.
  void setStateColor(const QColor& color) {
    state_ = color;
    update();
  }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double paintPart(QPainter& painter, const LegendPart& part, const QRectF& room) const;

  MapView& view_;
  QColor state_;
};

}  // namespace editor
