#pragma once

#include <vector>

#include <QWidget>

#include "app/run/Futures.h"
#include "editor/look/Theme.h"

class QwtPlot;
class QwtPlotCurve;
class QwtPlotGrid;
class QwtPlotIntervalCurve;
class QwtPlotMarker;

namespace editor {

/// The chance of a contact over time with its interval, a line at the moment that is shown and one
/// where half of the contacts have happened.
class ChancePlot : public QWidget {
  Q_OBJECT
 public:
  explicit ChancePlot(const Theme& theme);
  void setTheme(const Theme& theme);
  void show(const std::vector<app::ContactChance>& chances, std::optional<double> decisive);
  void setCursor(double time);  // [s]

 private:
  QwtPlot* plot_;
  QwtPlotGrid* grid_;  // these belong to the plot
  QwtPlotIntervalCurve* band_;
  QwtPlotCurve* curve_;
  QwtPlotMarker *cursor_, *decisive_;
};

/// How plots of a run look: thin axes, seconds below.
void stylePlot(QwtPlot& plot, const Theme& theme);
void layOutPlot(QwtPlot& plot);

}  // namespace editor
