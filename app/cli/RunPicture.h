#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QPainter>
#include <QSizeF>

#include "app/cli/FigureMap.h"
#include "sim2d/trace/Trace.h"

namespace app {

/// The legend of bodies in a figure, in a column beside the map or in columns below it.
class FigureLegend {
 public:
  FigureLegend(const sim2d::Trace& trace, const FigureMap& map, const FigureSizes& sizes,
               const FigureText& text);

  /// The height [px] with all bodies, limited so that the picture does not become too tall.
  double heightBeside() const;
  double heightBelow(double width) const;
  /// `leftTop`: of the title; `foot`: baseline of the last line.
  void paintBeside(QPainter& painter, const QPointF& leftTop, double foot, const QString& when,
                   const QString& last) const;
  void paintBelow(QPainter& painter, const QPointF& leftTop, double width,
                  const QString& when) const;

 private:
  struct Entry {
    int id = 0;
    QString name, kind;
  };
  std::vector<Entry> entriesOf(const sim2d::Trace& trace) const;
  int columns(double width) const;
  int rows(double width) const;
  void row(QPainter& painter, const QPointF& at, const Entry& entry, double width) const;

  const QString title_;
  const FigureMap& map_;
  const FigureSizes sizes_;
  const FigureText& text_;
  const std::vector<Entry> entries_;
};

/// The legend of the overlays of a figure, in lines below the map.
class OverlayLegend {
 public:
  OverlayLegend(const FigureMap& map, const FigureSizes& sizes, const FigureText& text,
                const FigureOptions& options);
  double height(double width) const;  // [px]; 0 without overlays and marks
  void paint(QPainter& painter, const QPointF& leftTop, double width) const;

 private:
  struct Item {
    double width = 0.0;                                    // [px], including the gap
    std::function<void(QPainter&, const QPointF&)> paint;  // at the left end, on the baseline
  };
  std::vector<Item> items() const;
  Item textItem(double sample, const QString& label,
                std::function<void(QPainter&, const QPointF&)> paintSample) const;
  void addArrows(std::vector<Item>& items) const;

  const FigureMap& map_;
  const FigureSizes sizes_;
  const FigureText& text_;
  const FigureOptions options_;
};

/// The parts of a figure of a run, and its foot: scale bar, legends.
class RunFigure {
 public:
  Q_DISABLE_COPY_MOVE(RunFigure)         // members refer to each other
  QSizeF size() const { return size_; }  // [px]
  QColor ground() const { return text_.theme().color(editor::Role::MapFree); }

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

/// The picture of a run for a paper: map and obstacles on white (dark theme: on dark), trajectories
/// that fade from light to full, starts as rings, goals as pins, legend and scale. One thread;
/// requires a QGuiApplication. The trace must outlive it.
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
