#pragma once

#include <memory>
#include <vector>

#include <QtWidgets>

#include "app/run/Futures.h"
#include "app/run/RunComparison.h"
#include "editor/look/Theme.h"

class QwtPlot;
class QwtPlotCurve;
class QwtPlotGrid;
class QwtPlotIntervalCurve;
class QwtPlotMarker;

namespace editor {

/// The probability of a contact over time with its confidence interval, and lines at the shown time
/// and at the median contact time.
class ContactProbabilityPlot : public QWidget {
  Q_OBJECT
 public:
  explicit ContactProbabilityPlot(const Theme& theme);
  void setTheme(const Theme& theme);
  void show(const std::vector<app::ContactChance>& chances, std::optional<double> decisive);
  void setCursor(double time);  // [s]

 private:
  QwtPlot* plot_;
  QwtPlotGrid* grid_;  // The items belong to the plot.
  QwtPlotIntervalCurve* band_;
  QwtPlotCurve* curve_;
  QwtPlotMarker *cursor_, *decisive_;
};

/// One metric over time, of one run or of several runs in different styles, with a line at the
/// shown time.
class MetricPlot : public QWidget {
  Q_OBJECT
 public:
  /// `isSingle`: for one run, with a thinner curve and a right margin that fits the last label.
  explicit MetricPlot(const Theme& theme, bool isSingle = false);
  ~MetricPlot() override;
  Q_DISABLE_COPY_MOVE(MetricPlot)
  void setTheme(const Theme& theme);
  /// Null curve: none. The first line is the shown run.
  struct Line {
    const app::MetricTimeSeries* curve = nullptr;
    int style = -1;  // -1: the shown run.
  };
  void show(const QString& name, const QString& unit, const std::vector<Line>& lines);
  void setCursor(double time);  // [s]
  std::size_t lines() const { return curves_.size(); }

 Q_SIGNALS:
  /// The context menu was requested at this time [s] of the run.
  void menuRequested(double time, const QPoint& globalPos);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void applyStyles();
  void reserveEnd();
  Theme theme_;
  const bool isSingle_;
  QLabel *title_, *unit_;
  QwtPlot* plot_;
  QwtPlotGrid* grid_;  // Belongs to the plot.
  QwtPlotMarker* cursor_;
  std::vector<std::unique_ptr<QwtPlotCurve>> curves_;
  std::vector<int> styles_;
};

}  // namespace editor
