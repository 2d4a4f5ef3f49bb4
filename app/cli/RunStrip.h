#pragma once

#include <memory>
#include <vector>

#include "app/cli/FigureLegend.h"

namespace app {

/// Some instants of a run side by side, (a), (b), …, with one scale and one legend for all. One
/// thread; needs a QGuiApplication, and the trace as long as it lives.
class RunStrip {
 public:
  /// `times` [s], in the order in which they are shown; at least one. The height follows.
  RunStrip(const sim2d::Trace& trace, const PictureLayout& layout, std::vector<double> times);
  ~RunStrip() = default;
  Q_DISABLE_COPY_MOVE(RunStrip)  // parts know each other

  QSizeF size() const { return size_; }  // [px]
  void paint(QPainter& painter);
  int columns() const { return columns_; }

 private:
  QRectF cellOf(std::size_t k) const;

  const long long seed_;
  const std::vector<double> times_;
  const FigureMeasures measures_;
  const FigureText text_;
  FigureMap map_;
  const FigureLegend legend_;
  const FigureKey key_;
  int columns_ = 1;
  QSizeF cell_;  // [px], of one map
  QSizeF size_;
};

/// So many instants at equal distances, the first at the begin and the last at the end.
std::vector<double> evenTimes(const sim2d::Trace& trace, int count);

}  // namespace app
