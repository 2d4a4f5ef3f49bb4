#include "editor/panels/MetricPlot.h"

#include <cmath>

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>

#include "editor/look/Form.h"

namespace editor {

namespace {

constexpr int kLeastMargin = 12;  // at the right [px]

class SecondsDraw : public QwtScaleDraw {
 public:
  QwtText label(double value) const override { return QwtText(QStringLiteral("%1 s").arg(value)); }
};

}  // namespace

MetricPlot::MetricPlot(const Theme& theme, QWidget* parent)
    : QWidget(parent),
      title_(new QLabel(this)),
      unit_(secondaryLabel({}, this)),
      plot_(new QwtPlot(this)),
      grid_(new QwtPlotGrid),
      curve_(new QwtPlotCurve),
      cursor_(new QwtPlotMarker) {
  auto* top = new QHBoxLayout;
  top->setContentsMargins(12, 6, 12, 0);
  title_->setWordWrap(true);
  top->addWidget(title_, 1);
  top->addWidget(unit_, 0, Qt::AlignTop);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 4);
  layout->setSpacing(0);
  layout->addLayout(top);
  layout->addWidget(plot_, 1);
  layOut();
  setTheme(theme);
  setMinimumWidth(180);
}

void MetricPlot::layOut() {
  plot_->setMinimumSize(120, 60);
  plot_->setFrameShape(QFrame::NoFrame);
  static_cast<QwtPlotCanvas*>(plot_->canvas())->setFrameStyle(QFrame::NoFrame);
  plot_->setAxisScaleDraw(QwtPlot::xBottom, new SecondsDraw);
  plot_->setAxisMaxMajor(QwtPlot::xBottom, 5);
  plot_->setAxisMaxMajor(QwtPlot::yLeft, 4);
  plot_->setAxisMaxMinor(QwtPlot::xBottom, 0);
  plot_->setAxisMaxMinor(QwtPlot::yLeft, 0);
  for (const int axis : {int(QwtPlot::xBottom), int(QwtPlot::yLeft)}) {
    plot_->axisScaleDraw(axis)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
    plot_->axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MajorTick, 3);
  }
  grid_->enableX(false);
  grid_->attach(plot_);
  curve_->setRenderHint(QwtPlotItem::RenderAntialiased);
  curve_->attach(plot_);
  cursor_->setLineStyle(QwtPlotMarker::VLine);
  cursor_->attach(plot_);
}

void MetricPlot::setTheme(const Theme& theme) {
  title_->setFont(theme.font(9.5, QFont::DemiBold));
  plot_->setCanvasBackground(theme.color(Role::Panel));
  QPalette colors = plot_->palette();
  colors.setColor(QPalette::Window, theme.color(Role::Panel));
  colors.setColor(QPalette::WindowText, theme.color(Role::FieldEdge));
  colors.setColor(QPalette::Text, theme.color(Role::TextSecondary));
  plot_->setPalette(colors);
  plot_->setAutoFillBackground(true);
  for (const int axis : {int(QwtPlot::xBottom), int(QwtPlot::yLeft)}) {
    plot_->axisWidget(axis)->setPalette(colors);
    plot_->setAxisFont(axis, theme.font(8.0));
  }
  grid_->setPen(theme.color(Role::Line), 1.0);
  curve_->setPen(theme.color(Role::Accent), 1.8);
  cursor_->setLinePen(theme.color(Role::TextSecondary), 1.0, Qt::DashLine);
  plot_->replot();
}

void MetricPlot::show(const metrics::MetricResult* result, const MetricCurve* curve) {
  title_->setText(result != nullptr ? QString::fromStdString(result->info.name) : QString());
  unit_->setText(result != nullptr ? QString::fromStdString(result->info.unit) : QString());
  QVector<QPointF> points;
  if (curve != nullptr) {
    for (std::size_t i = 0; i < curve->times.size(); ++i) {
      if (std::isfinite(curve->values[i])) {
        points.push_back({curve->times[i], curve->values[i]});
      }
    }
  }
  curve_->setSamples(points);
  const bool any = !points.isEmpty();
  const double end = curve != nullptr && !curve->times.empty() ? curve->times.back() : 1.0;
  plot_->setAxisScale(QwtPlot::xBottom, 0.0, std::max(end, 1.0));
  reserveEnd();
  if (any) {
    plot_->setAxisAutoScale(QwtPlot::yLeft);
  } else {
    plot_->setAxisScale(QwtPlot::yLeft, 0.0, 1.0);
  }
  plot_->replot();
}

/// Half of the last time stands beyond the end of the axis.
void MetricPlot::reserveEnd() {
  plot_->updateAxes();
  const QList<double> ticks = plot_->axisScaleDiv(QwtPlot::xBottom).ticks(QwtScaleDiv::MajorTick);
  if (ticks.isEmpty()) {
    return;
  }
  const QString last = plot_->axisScaleDraw(QwtPlot::xBottom)->label(ticks.back()).text();
  const QFontMetrics metrics(plot_->axisFont(QwtPlot::xBottom));
  plot_->setContentsMargins(0, 0, std::max(kLeastMargin, metrics.horizontalAdvance(last) / 2 + 4),
                            0);
}

void MetricPlot::setCursor(double time) {
  cursor_->setXValue(time);
  plot_->replot();
}

}  // namespace editor
