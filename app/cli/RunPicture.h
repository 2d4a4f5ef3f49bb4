#pragma once

#include <optional>
#include <vector>

#include <QPainter>
#include <QSizeF>

#include "app/cli/FigureLegend.h"
#include "app/cli/FigureStyle.h"
#include "sim2d/trace/Trace.h"

namespace app {

/// The parts of a figure of a run, and its foot: scale bar, legends.
class RunFigure {
 public:
  Q_DISABLE_COPY_MOVE(RunFigure)         // members refer to each other
  QSizeF size() const { return size_; }  // [px]

 protected:
  RunFigure(const sim2d::Trace& trace, const FigureSizes& sizes, bool textAsOutlines,
            const FigureOptions& options);
  ~RunFigure() = default;

  void paintGround(QPainter& painter) const;
  /// Paints scale bar and legend of the overlays below `leftTop`; returns their lower edge.
  double paintFoot(QPainter& painter, const QPointF& leftTop, double width) const;

  const long long seed_;
  const FigureSizes sizes_;
  const FigureText text_;
  FigureMap map_;
  const FigureLegend legend_;
  const OverlayLegend key_;
  QSizeF size_;
};

/// The picture of a run for a paper: map and obstacles on white, trajectories that fade from light
/// to full, starts as rings, goals as pins, legend and scale. One thread; requires a
/// QGuiApplication. The trace must outlive it.
class RunPicture : public RunFigure {
 public:
  RunPicture(const sim2d::Trace& trace, const PictureLayout& layout);
  /// Paints the state at this time [s]; nullopt: the whole run, with all bodies at their last
  /// positions.
  void paint(QPainter& painter, std::optional<double> time = {});
};

/// Several instants of a run side by side, (a), (b), …, with a common scale and legend. One thread;
/// requires a QGuiApplication. The trace must outlive it.
class RunStrip : public RunFigure {
 public:
  /// `times` [s], in display order; at least one. The height follows from them.
  RunStrip(const sim2d::Trace& trace, const PictureLayout& layout, std::vector<double> times);
  void paint(QPainter& painter);

 private:
  QRectF cellOf(std::size_t k) const;

  const std::vector<double> times_;
  int columns_ = 1;
  QSizeF cell_;  // [px], of one map
};

/// `count` equidistant times from the start to the end of the run.
std::vector<double> equidistantTimes(const sim2d::Trace& trace, int count);

}  // namespace app
