#include "editor/panels/runs/ScatterPlot.h"

#include <algorithm>
#include <cmath>

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_draw.h>
#include <qwt_symbol.h>
#include <qwt_text.h>

#include "editor/look/Form.h"
#include "editor/panels/runs/PlotStyle.h"

namespace editor {

namespace {

constexpr int kPointReach = 12;        // From the pointer to a point [px].
constexpr double kPlaneMargin = 0.08;  // Beyond the points, share of their range.
constexpr int kNameGap = 6;            // Between a point and its name [px].

struct PlotRange {
  double low = 0.0, high = 1.0;
};

PlotRange rangeOfPoints(const PlottedPoints& shown, double PlottedPoint::*coordinate) {
  if (shown.points.empty()) {
    return {};
  }
  PlotRange range{0.0, 0.0};
  bool isFirst = !shown.isFromZero;
  for (const PlottedPoint& point : shown.points) {
    const double value = point.*coordinate;
    range.low = isFirst ? value : std::min(range.low, value);
    range.high = isFirst ? value : std::max(range.high, value);
    isFirst = false;
  }
  const double length = range.high - range.low;
  const double margin =
      length > 0.0 ? kPlaneMargin * length : std::max(1e-6, std::fabs(range.high));
  return {shown.isFromZero ? 0.0 : range.low - margin, range.high + margin};
}

QwtPlotCurve* pointCurve(QwtPlot& plot, double z) {
  auto* curve = new QwtPlotCurve;
  curve->setStyle(QwtPlotCurve::NoCurve);
  curve->setRenderHint(QwtPlotItem::RenderAntialiased);
  curve->setZ(z);
  curve->attach(&plot);
  return curve;
}

/// The upper left corner of a name of this size on a side of its point `at` [px].
QPointF nameCorner(Qt::AlignmentFlag side, const QPointF& at, const QSizeF& size) {
  if (side == Qt::AlignRight) {
    return {at.x() + kNameGap, at.y() - size.height() / 2.0};
  }
  if (side == Qt::AlignLeft) {
    return {at.x() - kNameGap - size.width(), at.y() - size.height() / 2.0};
  }
  const double y = side == Qt::AlignTop ? at.y() - kNameGap - size.height() : at.y() + kNameGap;
  return {at.x() - size.width() / 2.0, y};
}

}  // namespace

ScatterPlot::ScatterPlot(const Theme& theme, const QString& accessibleName, QWidget* parent)
    : QWidget(parent),
      theme_(theme),
      plot_(new QwtPlot(this)),
      grid_(new QwtPlotGrid),
      line_(new QwtPlotCurve),
      weak_(pointCurve(*plot_, 20.0)),
      strong_(pointCurve(*plot_, 30.0)),
      outlined_(pointCurve(*plot_, 31.0)),
      selected_(pointCurve(*plot_, 40.0)) {
  configuredLayout(new QVBoxLayout(this), {0, 4, 8, 4}, 0, {plot_});
  useThinAxes(*plot_);
  plot_->setMinimumSize(160, 100);
  grid_->attach(plot_);
  line_->setRenderHint(QwtPlotItem::RenderAntialiased);
  line_->attach(plot_);
  plot_->canvas()->installEventFilter(this);
  setAccessibleName(accessibleName);
  stylePlot(*plot_, theme);
  applyStyles();
}

ScatterPlot::~ScatterPlot() = default;

void ScatterPlot::applyStyles() {
  const QColor accent = theme_.color(Role::Accent);
  const QColor dim = theme_.color(Role::TextSecondary);
  grid_->setPen(theme_.color(Role::Line), 1.0);
  line_->setPen(accent, 1.0);
  weak_->setSymbol(new QwtSymbol(QwtSymbol::Ellipse, withAlpha(dim, 0.5), QPen(Qt::NoPen), {6, 6}));
  strong_->setSymbol(new QwtSymbol(QwtSymbol::Ellipse, accent, QPen(Qt::NoPen), {8, 8}));
  outlined_->setSymbol(
      new QwtSymbol(QwtSymbol::Rect, Qt::NoBrush, QPen(theme_.color(Role::Text), 1.5), {12, 12}));
  selected_->setSymbol(new QwtSymbol(QwtSymbol::Ellipse, Qt::NoBrush,
                                     QPen(theme_.color(Role::Text), 2.0), {16, 16}));
  for (const auto& slope : slopes_) {
    slope->setPen(dim, 1.0, Qt::DashLine);
  }
  const auto title = [this](int axis, const QString& words) {
    QwtText text(words);
    text.setRenderFlags(text.renderFlags() | Qt::TextWordWrap);  // low plots have short axes
    text.setFont(theme_.font(9.0));
    text.setColor(theme_.color(Role::Text));
    plot_->setAxisTitle(axis, text);
  };
  title(QwtPlot::xBottom, shown_.xTitle);
  title(QwtPlot::yLeft, shown_.yTitle);
  placeNames();
}

void ScatterPlot::show(PlottedPoints shown) {
  shown_ = std::move(shown);
  current_ = -1;
  QVector<QPointF> weak, strong, outlined;
  for (const PlottedPoint& point : shown_.points) {
    (point.isStrong ? strong : weak).append({point.x, point.y});
    if (point.isOutlined) {
      outlined.append({point.x, point.y});
    }
  }
  weak_->setSamples(weak);
  strong_->setSamples(strong);
  outlined_->setSamples(outlined);
  selected_->setSamples(QVector<QPointF>());
  line_->setSamples(QVector<QPointF>(shown_.line.begin(), shown_.line.end()));
  setScales();
  applyStyles();
}

/// The dashed lines end where they leave the plane.
void ScatterPlot::setScales() {
  const PlotRange across = rangeOfPoints(shown_, &PlottedPoint::x);
  const PlotRange up = rangeOfPoints(shown_, &PlottedPoint::y);
  plot_->setAxisScale(QwtPlot::xBottom, across.low, across.high);
  plot_->setAxisScale(QwtPlot::yLeft, up.low, up.high);
  slopes_.clear();
  for (const double slope : shown_.slopes) {
    const double end = slope > 0.0 ? std::min(across.high, up.high / slope) : across.high;
    auto line = std::make_unique<QwtPlotCurve>();
    line->setSamples(QVector<QPointF>{{0.0, 0.0}, {end, slope * end}});
    line->attach(plot_);
    slopes_.push_back(std::move(line));
  }
  plot_->updateAxes();
}

QPointF ScatterPlot::onCanvas(const PlottedPoint& point) const {
  return {plot_->transform(QwtPlot::xBottom, point.x), plot_->transform(QwtPlot::yLeft, point.y)};
}

QPoint ScatterPlot::placeOf(int point) const {
  const QPointF at = onCanvas(shown_.points[static_cast<std::size_t>(point)]);
  return plot_->canvas()->mapTo(this, at.toPoint());
}

void ScatterPlot::addMarker(double x, double y, const QString& text, Qt::Alignment side) {
  QwtText label(text);
  label.setFont(theme_.font(8.5));
  label.setColor(theme_.color(Role::Text));
  auto marker = std::make_unique<QwtPlotMarker>();
  marker->setValue(x, y);
  marker->setLabel(label);
  marker->setLabelAlignment(side);
  marker->setSpacing(kNameGap);
  marker->setZ(50.0);
  marker->attach(plot_);
  names_.push_back(std::move(marker));
}

/// Names that would cover another one or leave the canvas are omitted; tooltips have them.
void ScatterPlot::placeNames() {
  names_.clear();
  const QFontMetricsF metrics(theme_.font(8.5));
  const QRectF canvas(QPointF(), QSizeF(plot_->canvas()->size()));
  std::vector<QRectF> taken;
  for (const PlottedPoint& point : shown_.points) {
    if (point.name.isEmpty()) {
      continue;
    }
    const QSizeF size(metrics.horizontalAdvance(point.name), metrics.height());
    const QPointF at = onCanvas(point);
    for (const Qt::AlignmentFlag side :
         {Qt::AlignRight, Qt::AlignLeft, Qt::AlignTop, Qt::AlignBottom}) {
      const QRectF box(nameCorner(side, at, size), size);
      const bool isFree = std::none_of(taken.begin(), taken.end(), [&box](const QRectF& other) {
        return other.intersects(box);
      });
      if (isFree && canvas.contains(box)) {
        addMarker(point.x, point.y, point.name, side);
        taken.push_back(box);
        break;
      }
    }
  }
  plot_->replot();
}

void ScatterPlot::setCurrent(int point) {
  const bool isPoint = point >= 0 && point < static_cast<int>(shown_.points.size());
  current_ = isPoint ? point : -1;
  QVector<QPointF> samples;
  if (isPoint) {
    const PlottedPoint& at = shown_.points[static_cast<std::size_t>(point)];
    samples.append({at.x, at.y});
  }
  selected_->setSamples(samples);
  plot_->replot();
}

int ScatterPlot::pointAt(const QPoint& place) const {
  int nearest = -1;
  double least = kPointReach;
  for (std::size_t k = 0; k < shown_.points.size(); ++k) {
    const QPointF off = onCanvas(shown_.points[k]) - QPointF(place);
    const double distance = std::hypot(off.x(), off.y());
    if (distance <= least) {
      least = distance;
      nearest = static_cast<int>(k);
    }
  }
  return nearest;
}

bool ScatterPlot::eventFilter(QObject* watched, QEvent* event) {
  if (watched == plot_->canvas() && event->type() == QEvent::ToolTip) {
    const auto& help = *static_cast<QHelpEvent*>(event);
    const int point = pointAt(help.pos());
    const QString tip = point < 0 ? QString() : shown_.points[static_cast<std::size_t>(point)].tip;
    QToolTip::showText(help.globalPos(), tip, plot_->canvas());
    return true;
  }
  if (watched == plot_->canvas() && event->type() == QEvent::MouseButtonPress) {
    const int point = pointAt(static_cast<QMouseEvent*>(event)->pos());
    if (point >= 0) {
      Q_EMIT pointClicked(point);
    }
  }
  return QWidget::eventFilter(watched, event);
}

void ScatterPlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  plot_->updateLayout();
  placeNames();
}

}  // namespace editor
