#pragma once

#include <memory>
#include <vector>

#include <QLabel>
#include <QWidget>

#include "app/run/Comparison.h"
#include "editor/look/Theme.h"

class QwtPlot;
class QwtPlotCurve;
class QwtPlotGrid;
class QwtPlotMarker;

namespace editor {

/// One metric of several runs over time, each in its style.
class ComparePlot : public QWidget {
  Q_OBJECT
 public:
  explicit ComparePlot(const Theme& theme);
  ~ComparePlot() override;
  Q_DISABLE_COPY_MOVE(ComparePlot)
  void setTheme(const Theme& theme);
  /// `curves`: of the run that is shown, then of those in the styles; null: none.
  struct Line {
    const app::MeasuredCurve* curve = nullptr;
    int style = -1;  // -1: the run that is shown
  };
  void show(const QString& name, const QString& unit, const std::vector<Line>& lines);
  void setCursor(double time);  // [s]
  std::size_t lines() const { return curves_.size(); }

 private:
  void applyStyles();
  Theme theme_;
  QLabel *title_, *unit_;
  QwtPlot* plot_;
  QwtPlotGrid* grid_;  // belongs to the plot
  QwtPlotMarker* cursor_;
  std::vector<std::unique_ptr<QwtPlotCurve>> curves_;
  std::vector<int> styles_;
};

}  // namespace editor
