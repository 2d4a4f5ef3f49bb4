#pragma once

#include <QLabel>
#include <QWidget>

#include "editor/look/Theme.h"
#include "editor/panels/MetricsFeed.h"

class QwtPlot;
class QwtPlotCurve;
class QwtPlotGrid;
class QwtPlotMarker;

namespace editor {

/// One metric over time, with a line at the moment that is shown.
class MetricPlot : public QWidget {
  Q_OBJECT
 public:
  explicit MetricPlot(const Theme& theme, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void show(const metrics::MetricResult* result, const MetricCurve* curve);
  void setCursor(double time);  // [s]
  QwtPlot& plot() const { return *plot_; }

 private:
  void layOut();
  void reserveEnd();
  QLabel* title_;
  QLabel* unit_;
  QwtPlot* plot_;
  QwtPlotGrid* grid_;  // these belong to the plot
  QwtPlotCurve* curve_;
  QwtPlotMarker* cursor_;
};

}  // namespace editor
