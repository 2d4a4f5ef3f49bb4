#include "editor/panels/runs/RunPlots.h"

#include <algorithm>
#include <cmath>

#include <qwt_plot.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_intervalcurve.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>

#include "editor/canvas/ComparedRunLayers.h"
#include "editor/look/CoreText.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/Form.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/runs/PlotStyle.h"

namespace editor {

namespace {

constexpr int kLeastPlotHeight = 60;

constexpr double kAhead = 10.0;  // Initial time range without data [s].

class UnitDraw : public QwtScaleDraw {
 public:
  UnitDraw(double factor, QString unit) : factor_(factor), unit_(std::move(unit)) {}
  QwtText label(double value) const override {
    return QwtText(QStringLiteral("%1 %2").arg(factor_ * value).arg(unit_));
  }

 private:
  double factor_;
  QString unit_;
};

/// Thin axes, seconds on the x axis.
void layOutPlot(QwtPlot& plot) {
  constexpr int kRightMargin = 20;  // Half of the last label extends beyond the axis [px].
  plot.setMinimumSize(120, 60);
  plot.setAxisScaleDraw(QwtPlot::xBottom, new UnitDraw(1.0, QStringLiteral("s")));
  useThinAxes(plot);
  plot.setContentsMargins(0, 0, kRightMargin, 0);
}

/// Limits the number of labels of the time axis to those that fit beside each other.
void fitTimeAxis(QwtPlot& plot) {
  constexpr int kMostLabels = 5;
  constexpr int kGap = 12;  // [px]
  const QFontMetrics metrics(plot.axisFont(QwtPlot::xBottom));
  const int label = metrics.horizontalAdvance(QStringLiteral("00.5 s")) + kGap;
  const int count = std::clamp(plot.canvas()->width() / label, 1, kMostLabels);
  if (plot.axisMaxMajor(QwtPlot::xBottom) != count) {
    plot.setAxisMaxMajor(QwtPlot::xBottom, count);
  }
}

/// The samples of a curve; `factor` converts its values to the unit of the figure.
PlottedCurve plottedCurve(const QwtPlotCurve& curve, const QString& label, double factor = 1.0) {
  PlottedCurve plotted;
  plotted.label = label;
  for (std::size_t k = 0; k < curve.dataSize(); ++k) {
    plotted.times.push_back(curve.sample(static_cast<int>(k)).x());
    plotted.values.push_back(factor * curve.sample(static_cast<int>(k)).y());
  }
  return plotted;
}

}  // namespace

void ExportablePlot::contextMenuEvent(QContextMenuEvent* event) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setToolTipsVisible(true);
  extendMenu(*menu, *event);
  if (!menu->isEmpty()) {
    menu->addSeparator();
  }
  const auto add = [&](const QString& text, const QString& tip, bool toFile) {
    QAction* action = menu->addAction(text, this, [this, toFile] {
      later(*this, [this, toFile] { Q_EMIT exportRequested(figure(), toFile); });
    });
    describe(*action, tip);
    action->setEnabled(!figure().curves.empty());
  };
  add(tr("Copy plot"), tr("Copy the plot as PNG and SVG"), false);
  add(tr("Save plot…"), tr("Save the plot as PNG, SVG or PDF"), true);
  menu->popup(event->globalPos());
}

void connectExport(const ExportablePlot& plot, PanelContext& context) {
  QObject::connect(&plot, &ExportablePlot::exportRequested, &context,
                   &PanelContext::plotExportRequested);
}

ContactProbabilityPlot::ContactProbabilityPlot(const Theme& theme)
    : plot_(new QwtPlot(this)),
      grid_(new QwtPlotGrid),
      band_(new QwtPlotIntervalCurve),
      curve_(new QwtPlotCurve),
      cursor_(new QwtPlotMarker),
      decisive_(new QwtPlotMarker) {
  configuredLayout(new QVBoxLayout(this), {0, 4, 0, 4}, 0, {plot_});
  layOutPlot(*plot_);
  plot_->setAxisScaleDraw(QwtPlot::yLeft, new UnitDraw(100.0, QStringLiteral("%")));
  plot_->axisScaleDraw(QwtPlot::yLeft)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
  plot_->axisScaleDraw(QwtPlot::yLeft)->setTickLength(QwtScaleDiv::MajorTick, 3);
  plot_->setAxisScale(QwtPlot::yLeft, 0.0, 1.0, 0.5);
  grid_->enableX(false);
  grid_->attach(plot_);
  band_->setStyle(QwtPlotIntervalCurve::Tube);
  band_->attach(plot_);
  curve_->setStyle(QwtPlotCurve::Steps);
  curve_->setCurveAttribute(QwtPlotCurve::Inverted, true);  // Steps rise at the time of a contact.
  curve_->setRenderHint(QwtPlotItem::RenderAntialiased);
  curve_->attach(plot_);
  for (QwtPlotMarker* marker : {cursor_, decisive_}) {
    marker->setLineStyle(QwtPlotMarker::VLine);
    marker->attach(plot_);
  }
  setCursor(0.0);
  setTheme(theme);
  setMinimumWidth(220);
  setAccessibleName(tr("Probability of contact over time"));
}

void ContactProbabilityPlot::setTheme(const Theme& theme) {
  stylePlot(*plot_, theme);
  grid_->setPen(theme.color(Role::Line), 1.0);
  band_->setPen(QPen(Qt::NoPen));
  band_->setBrush(theme.color(Role::Error, 0.18));
  curve_->setPen(theme.color(Role::Error), 2.0);
  cursor_->setLinePen(theme.color(Role::TextSecondary), 1.0, Qt::DashLine);
  decisive_->setLinePen(theme.color(Role::WarningMark), 2.0, Qt::DotLine);
  plot_->replot();
}

void ContactProbabilityPlot::show(const std::vector<app::ContactChance>& chances,
                                  std::optional<double> decisive) {
  QVector<QPointF> points;
  QVector<QwtIntervalSample> band;
  for (const app::ContactChance& each : chances) {
    points.push_back({each.time, each.chance});
    if (each.interval.isDefined()) {
      band.push_back({each.time, each.interval.low, each.interval.high});
    }
  }
  curve_->setSamples(points);
  band_->setSamples(band);
  if (!points.isEmpty()) {
    plot_->setAxisScale(QwtPlot::xBottom, points.front().x(),
                        std::max(points.back().x(), points.front().x() + 0.1));
  } else {
    setCursor(cursor_->xValue());
  }
  decisive_->setVisible(decisive.has_value());
  decisive_->setXValue(decisive.value_or(0.0));
  plot_->replot();
}

void ContactProbabilityPlot::setCursor(double time) {
  cursor_->setXValue(time);
  if (curve_->dataSize() == 0) {
    plot_->setAxisScale(QwtPlot::xBottom, time, time + kAhead);
  }
  plot_->replot();
}

PlottedFigure ContactProbabilityPlot::figure() const {
  constexpr double kPercent = 100.0;
  PlottedFigure figure{accessibleName(), QStringLiteral("%"), {}};
  if (curve_->dataSize() == 0) {
    return figure;
  }
  figure.curves.push_back(plottedCurve(*curve_, tr("share of the futures"), kPercent));
  PlottedCurve low{tr("lower limit (95 % CI)"), {}, {}};
  PlottedCurve high{tr("upper limit"), {}, {}};
  for (std::size_t k = 0; k < band_->dataSize(); ++k) {
    const QwtIntervalSample sample = band_->sample(static_cast<int>(k));
    low.times.push_back(sample.value);
    low.values.push_back(kPercent * sample.interval.minValue());
    high.times.push_back(sample.value);
    high.values.push_back(kPercent * sample.interval.maxValue());
  }
  if (!low.times.empty()) {
    figure.curves.push_back(std::move(low));
    figure.curves.push_back(std::move(high));
  }
  return figure;
}

void ContactProbabilityPlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitTimeAxis(*plot_);
  plot_->replot();
}

MetricPlot::MetricPlot(const Theme& theme, bool isSingle)
    : theme_(theme),
      isSingle_(isSingle),
      title_(new QLabel(this)),
      unit_(secondaryLabel({}, this)),
      plot_(new QwtPlot(this)),
      grid_(new QwtPlotGrid),
      cursor_(new QwtPlotMarker) {
  title_->setWordWrap(true);
  auto* top = configuredLayout(new QVBoxLayout, {12, 6, 12, 0}, 0, {title_, unit_});
  auto* layout = configuredLayout(new QVBoxLayout(this), {0, 0, 0, 4}, 0);
  layout->addLayout(top);
  layout->addWidget(plot_, 1);
  plot_->setMinimumHeight(kLeastPlotHeight);  // less than Qwt's, so that the lines above stay whole
  layOutPlot(*plot_);
  grid_->enableX(false);
  grid_->attach(plot_);
  cursor_->setLineStyle(QwtPlotMarker::VLine);
  cursor_->attach(plot_);
  setTheme(theme);
  setMinimumWidth(180);
}

MetricPlot::~MetricPlot() = default;

void MetricPlot::setTheme(const Theme& theme) {
  theme_ = theme;
  title_->setFont(theme.font(9.5, QFont::DemiBold));
  stylePlot(*plot_, theme);
  grid_->setPen(theme.color(Role::Line), 1.0);
  cursor_->setLinePen(theme.color(Role::TextSecondary), 1.0, Qt::DashLine);
  applyStyles();
  plot_->replot();
}

void MetricPlot::applyStyles() {
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    QPen pen(theme_.color(Role::Accent), isSingle_ ? 1.8 : 2.0);
    if (styles_[k] >= 0) {
      const GhostStyle style = ghostStyle(static_cast<std::size_t>(styles_[k]), theme_);
      pen.setColor(style.color);
      if (!style.dashes.isEmpty()) {
        pen.setDashPattern(style.dashes);
      }
    }
    curves_[k]->setPen(pen);
  }
}

void MetricPlot::show(const QString& name, const QString& unit, const std::vector<Line>& lines) {
  title_->setText(name);
  const auto known = std::find_if(lines.begin(), lines.end(),
                                  [](const Line& line) { return line.curve != nullptr; });
  QStringList words;
  axisUnit_ = unit;
  if (known != lines.end() && !known->curve->times.empty()) {
    axisUnit_ = coreText(known->curve->axisUnit());
    words << coreText(known->curve->meaning()) << QString::fromStdString(known->curve->unit);
  }
  words.removeAll(QString());
  unit_->setText(words.isEmpty() ? QString()
                                 : tr("Curve: %1").arg(words.join(QStringLiteral(" · "))));
  curves_.clear();
  styles_.clear();
  labels_.clear();
  double end = 1.0;
  bool any = false;
  for (const Line& line : lines) {
    if (line.curve == nullptr) {
      continue;
    }
    QVector<QPointF> points;
    for (std::size_t i = 0; i < line.curve->times.size(); ++i) {
      if (std::isfinite(line.curve->values[i])) {
        points.push_back({line.curve->times[i], line.curve->values[i]});
      }
      end = std::max(end, line.curve->times[i]);
    }
    any = any || !points.isEmpty();
    auto curve = std::make_unique<QwtPlotCurve>();
    curve->setRenderHint(QwtPlotItem::RenderAntialiased);
    curve->setSamples(points);
    curve->attach(plot_);
    curves_.push_back(std::move(curve));
    styles_.push_back(line.style);
    labels_ << line.label;
  }
  applyStyles();
  plot_->setAxisScale(QwtPlot::xBottom, 0.0, end);
  if (isSingle_) {
    reserveEnd();
  }
  if (any) {
    plot_->setAxisAutoScale(QwtPlot::yLeft);
  } else {
    plot_->setAxisScale(QwtPlot::yLeft, 0.0, 1.0);
  }
  plot_->replot();
}

/// By key: at the shown time.
void MetricPlot::extendMenu(QMenu& menu, const QContextMenuEvent& event) {
  if (curves_.empty()) {
    return;
  }
  const QPoint at = plot_->canvas()->mapFromGlobal(event.globalPos());
  const bool isPointed = event.reason() == QContextMenuEvent::Mouse;
  Q_EMIT menuRequested(
      isPointed ? std::max(0.0, plot_->invTransform(QwtPlot::xBottom, at.x())) : cursor_->xValue(),
      &menu);
}

/// Reserves space for half of the last label beyond the end of the axis.
void MetricPlot::reserveEnd() {
  constexpr int kMinMargin = 12;  // [px]
  plot_->updateAxes();
  const QList<double> ticks = plot_->axisScaleDiv(QwtPlot::xBottom).ticks(QwtScaleDiv::MajorTick);
  if (ticks.isEmpty()) {
    return;
  }
  const QString last = plot_->axisScaleDraw(QwtPlot::xBottom)->label(ticks.back()).text();
  const QFontMetrics metrics(plot_->axisFont(QwtPlot::xBottom));
  plot_->setContentsMargins(0, 0, std::max(kMinMargin, metrics.horizontalAdvance(last) / 2 + 4), 0);
}

PlottedFigure MetricPlot::figure() const {
  PlottedFigure figure{title_->text(), axisUnit_, {}};
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    if (curves_[k]->dataSize() > 0) {
      figure.curves.push_back(plottedCurve(*curves_[k], labels_[static_cast<int>(k)]));
    }
  }
  return figure;
}

void MetricPlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitTimeAxis(*plot_);
  plot_->replot();
}

void MetricPlot::setCursor(double time) {
  cursor_->setXValue(time);
  plot_->replot();
}

}  // namespace editor
