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

class PanelContext;

/// The curves of a plot, for files and the clipboard.
struct PlottedCurve {
  QString label;               // In the legend, if there are several curves.
  std::vector<double> times;   // [s]
  std::vector<double> values;  // Without undefined ones.
};
struct PlottedFigure {
  QString name, unit;
  std::vector<PlottedCurve> curves;
};

/// A plot whose context menu copies and saves it; the window does both (see
/// PanelContext::plotExportRequested).
class ExportablePlot : public QWidget {
  Q_OBJECT
 public:
  /// Empty: nothing to save.
  virtual PlottedFigure figure() const = 0;

 Q_SIGNALS:
  void exportRequested(const editor::PlottedFigure& plot, bool toFile);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  /// Adds more entries to the menu.
  virtual void extendMenu(QMenu& /*menu*/, const QContextMenuEvent& /*event*/) {}
};

/// Sends the requests of a plot to the window.
void connectExport(const ExportablePlot& plot, PanelContext& context);

/// The probability of a contact over time with its confidence interval, and lines at the shown time
/// and at the median contact time.
class ContactProbabilityPlot : public ExportablePlot {
  Q_OBJECT
 public:
  explicit ContactProbabilityPlot(const Theme& theme);
  void setTheme(const Theme& theme);
  void show(const std::vector<app::ContactChance>& chances, std::optional<double> decisive);
  void setCursor(double time);  // [s]
  PlottedFigure figure() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QwtPlot* plot_;
  QwtPlotGrid* grid_;  // The items belong to the plot.
  QwtPlotIntervalCurve* band_;
  QwtPlotCurve* curve_;
  QwtPlotMarker *cursor_, *decisive_;
};

/// One metric over time, of one run or of several runs in different styles, with a line at the
/// shown time.
class MetricPlot : public ExportablePlot {
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
    int style = -1;   // -1: the shown run.
    QString label{};  // In saved figures.
  };
  /// The unit and the meaning of the values ("per step") are those of the curves.
  void show(const QString& name, const QString& unit, const std::vector<Line>& lines);
  PlottedFigure figure() const override;
  void setCursor(double time);  // [s]
  std::size_t lines() const { return curves_.size(); }
  QString title() const { return title_->text(); }
  QString unitText() const { return unit_->text(); }  // "Curve: per step · m"

 protected:
  void resizeEvent(QResizeEvent* event) override;

 Q_SIGNALS:
  /// The context menu was requested at this time [s] of the run, for more entries.
  void menuRequested(double time, QMenu* menu);

 protected:
  void extendMenu(QMenu& menu, const QContextMenuEvent& event) override;

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
  QStringList labels_;
  QString axisUnit_;
};

}  // namespace editor
