#pragma once

#include <memory>
#include <vector>

#include <QtWidgets>

#include "editor/look/Theme.h"

class QwtPlot;
class QwtPlotCurve;
class QwtPlotGrid;
class QwtPlotMarker;

namespace editor {

/// A point of a ScatterPlot.
struct PlottedPoint {
  double x = 0.0, y = 0.0;
  QString name;             // beside the point, as far as there is space; empty: none
  QString tip;              // tooltip
  bool isStrong = true;     // otherwise drawn small in the secondary colour
  bool isOutlined = false;  // in a square, for example the values before a change
};

/// What a ScatterPlot shows.
struct PlottedPoints {
  QString xTitle, yTitle;
  std::vector<PlottedPoint> points;  // finite coordinates
  std::vector<QPointF> line;         // connects points, in order of x
  std::vector<double> slopes;        // dashed lines through the origin
  bool isFromZero = false;           // both axes begin at 0
};

/// Points in a plane. Hovering over a point shows its tooltip; a click on it is signalled. GUI
/// thread.
class ScatterPlot : public QWidget {
  Q_OBJECT
 public:
  ScatterPlot(const Theme& theme, const QString& accessibleName, QWidget* parent = nullptr);
  ~ScatterPlot() override;
  Q_DISABLE_COPY_MOVE(ScatterPlot)

  void show(PlottedPoints shown);
  const PlottedPoints& shown() const { return shown_; }
  /// Emphasises a point; -1: none.
  void setCurrent(int point);
  int current() const { return current_; }
  /// The place of a point in this widget [px].
  QPoint placeOf(int point) const;

 Q_SIGNALS:
  void pointClicked(int point);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  int pointAt(const QPoint& place) const;  // on the canvas [px]; -1: none
  QPointF onCanvas(const PlottedPoint& point) const;
  void setScales();
  void applyStyles();
  void placeNames();
  void addMarker(double x, double y, const QString& text, Qt::Alignment side);

  const Theme theme_;
  PlottedPoints shown_;
  int current_ = -1;
  QwtPlot* plot_;
  QwtPlotGrid* grid_;  // The items belong to the plot.
  QwtPlotCurve *line_, *weak_, *strong_, *outlined_, *selected_;
  std::vector<std::unique_ptr<QwtPlotCurve>> slopes_;
  std::vector<std::unique_ptr<QwtPlotMarker>> names_;
};

}  // namespace editor
