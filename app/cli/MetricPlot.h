#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "app/cli/FigureStyle.h"

namespace app {

/// A metric over the time of a run.
struct PlotCurve {
  QString name, unit;          // unit: empty = none
  std::vector<double> times;   // [s], ascending
  std::vector<double> values;  // NaN: undefined, a gap
};

/// Metrics over time for a paper, one panel above the other with a common time axis: vector
/// graphics, 8 pt labels with units. One thread; requires a QGuiApplication.
class MetricPlot {
 public:
  /// At least one curve. The height of `layout` is ignored.
  MetricPlot(std::vector<PlotCurve> curves, const PictureLayout& layout, QString caption = {});

  QSizeF size() const { return size_; }  // [px]
  /// With a vertical line at the time `at` [s], if given.
  void paint(QPainter& painter, std::optional<double> at = {}) const;

 private:
  struct Axis {
    double low = 0.0, high = 1.0, step = 0.2;
  };
  static Axis axisOf(const std::vector<double>& values);
  QRectF frameOf(std::size_t curve) const;
  void paintGrid(QPainter& painter, const QRectF& frame, const Axis& axis) const;
  void paintTimes(QPainter& painter, const QRectF& frame) const;
  void paintCurve(QPainter& painter, const QRectF& frame, const Axis& axis,
                  const PlotCurve& curve) const;

  const std::vector<PlotCurve> curves_;
  const FigureSizes sizes_;
  const FigureText text_;
  const QString caption_;
  double left_ = 0.0;                // [px] of the axes
  double first_ = 0.0, last_ = 1.0;  // [s]
  QSizeF size_;
};

/// The smallest 1, 2 or 5 times a power of ten of which at most `most` fit into `length`.
double niceStep(double length, int most);

}  // namespace app
