#include "editor/panels/ComparePlot.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_marker.h>

#include "editor/canvas/GhostLayer.h"
#include "editor/look/Form.h"
#include "editor/panels/ChancePlot.h"

namespace editor {

ComparePlot::ComparePlot(const Theme& theme)
    : theme_(theme),
      title_(new QLabel(this)),
      unit_(secondaryLabel({}, this)),
      plot_(new QwtPlot(this)),
      grid_(new QwtPlotGrid),
      cursor_(new QwtPlotMarker) {
  title_->setWordWrap(true);
  auto* top = arranged(new QHBoxLayout, {12, 6, 12, 0}, -1);
  top->addWidget(title_, 1);
  top->addWidget(unit_, 0, Qt::AlignTop);
  auto* layout = arranged(new QVBoxLayout(this), {0, 0, 0, 4}, 0);
  layout->addLayout(top);
  layout->addWidget(plot_, 1);
  layOutPlot(*plot_);
  grid_->enableX(false);
  grid_->attach(plot_);
  cursor_->setLineStyle(QwtPlotMarker::VLine);
  cursor_->attach(plot_);
  setTheme(theme);
  setMinimumWidth(180);
}

ComparePlot::~ComparePlot() = default;

void ComparePlot::setTheme(const Theme& theme) {
  theme_ = theme;
  title_->setFont(theme.font(9.5, QFont::DemiBold));
  stylePlot(*plot_, theme);
  grid_->setPen(theme.color(Role::Line), 1.0);
  cursor_->setLinePen(theme.color(Role::TextSecondary), 1.0, Qt::DashLine);
  applyStyles();
  plot_->replot();
}

void ComparePlot::applyStyles() {
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    QPen pen(theme_.color(Role::Accent), 2.0);
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

void ComparePlot::show(const QString& name, const QString& unit, const std::vector<Line>& lines) {
  title_->setText(name);
  unit_->setText(unit);
  curves_.clear();
  styles_.clear();
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
  }
  applyStyles();
  plot_->setAxisScale(QwtPlot::xBottom, 0.0, end);
  if (any) {
    plot_->setAxisAutoScale(QwtPlot::yLeft);
  } else {
    plot_->setAxisScale(QwtPlot::yLeft, 0.0, 1.0);
  }
  plot_->replot();
}

void ComparePlot::setCursor(double time) {
  cursor_->setXValue(time);
  plot_->replot();
}

}  // namespace editor
