#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "app/cli/FigureMap.h"

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

}  // namespace app
