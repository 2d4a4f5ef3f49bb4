#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QPainter>
#include <QSizeF>

#include "app/cli/FigureLegend.h"
#include "app/cli/FigureStyle.h"
#include "sim2d/trace/Trace.h"

namespace app {

/// The picture of a run for a paper: map and obstacles on white, trajectories that fade from light
/// to full, starts as rings, goals as pins, legend and scale. One thread; requires a
/// QGuiApplication. The trace must outlive it.
class RunPicture {
 public:
  RunPicture(const sim2d::Trace& trace, const PictureLayout& layout);
  ~RunPicture();
  RunPicture(const RunPicture&) = delete;
  RunPicture& operator=(const RunPicture&) = delete;
  RunPicture(RunPicture&&) = delete;
  RunPicture& operator=(RunPicture&&) = delete;

  QSizeF size() const;  // [px]
  /// Paints the state at this time [s]; nullopt: the whole run, with all bodies at their last
  /// positions.
  void paint(QPainter& painter, std::optional<double> time = {});

 private:
  class Painting;
  std::unique_ptr<Painting> painting_;
};

/// Several instants of a run side by side, (a), (b), …, with a common scale and legend. One thread;
/// requires a QGuiApplication. The trace must outlive it.
class RunStrip {
 public:
  /// `times` [s], in display order; at least one. The height follows from them.
  RunStrip(const sim2d::Trace& trace, const PictureLayout& layout, std::vector<double> times);
  ~RunStrip() = default;
  Q_DISABLE_COPY_MOVE(RunStrip)  // members refer to each other

  QSizeF size() const { return size_; }  // [px]
  void paint(QPainter& painter);
  int columns() const { return columns_; }

 private:
  QRectF cellOf(std::size_t k) const;

  const long long seed_;
  const std::vector<double> times_;
  const FigureSizes sizes_;
  const FigureText text_;
  FigureMap map_;
  const FigureLegend legend_;
  const OverlayLegend key_;
  int columns_ = 1;
  QSizeF cell_;  // [px], of one map
  QSizeF size_;
};

/// `count` equidistant times from the start to the end of the run.
std::vector<double> equidistantTimes(const sim2d::Trace& trace, int count);

}  // namespace app
