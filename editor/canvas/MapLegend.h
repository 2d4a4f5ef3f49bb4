#pragma once

#include <functional>
#include <vector>

#include <QWidget>

#include "editor/canvas/MapScene.h"

namespace editor {

class MapView;

/// What colours and signs of the overlays of a run say.
struct LegendRow {
  QString words, value;  // to the right; tabular digits
  /// In a box of 20 x 20 px; none: the words begin at the left.
  std::function<void(QPainter&, const QRectF&)> sample;
  bool isNote = false;  // in softer colour: what is not known
};
struct LegendPart {
  QString title;
  std::vector<LegendRow> rows;
};

/// Of everything that is switched on; empty while nothing of a run is. `pixelsPerMetre`: of the
/// view, for the scales of arrows.
std::vector<LegendPart> legendOf(const MapScene& scene, double pixelsPerMetre);
/// Whether an overlay is on that has a legend: then there is room for it, whoever is selected.
/// Laser scans, which are on at first, ask for it only while a robot with a lidar is selected.
bool wantsLegend(const MapScene& scene);
/// Costs of the cells of a planner's costmaps; what its ways cost, and what each critic gave the
/// chosen one (no rows: it does not tell).
LegendPart costPart(const MapScene& scene);
LegendPart pricePart(const MapScene& scene);
/// Of lidar, detector and ways weighed by the one robot that is selected.
std::vector<LegendRow> senseRows(const MapScene& scene);
/// One robot is selected in a run, and it has a lidar.
bool isLidarChosen(const MapScene& scene);

/// The legend at the right of a view, beside the map and never over it: the view is narrower for so
/// long.
class LegendStrip : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kWidth = 196;  // [px]
  explicit LegendStrip(MapView& view);
  void setStateColor(const QColor& color);  // of the line on top of the canvas

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double paintPart(QPainter& painter, const LegendPart& part, const QRectF& room) const;

  MapView& view_;
  QColor state_;
};

}  // namespace editor
