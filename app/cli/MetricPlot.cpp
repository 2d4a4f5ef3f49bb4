#include "app/cli/MetricPlot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "editor/canvas/ViewOverlays.h"

namespace app {

using editor::Role;

namespace {

constexpr double kPanelHeight = 84.0;  // [px], of a curve in a column
constexpr double kWidePanel = 120.0;   // [px], of a wide figure
constexpr double kCurveTitle = 18.0;   // above a curve
constexpr double kTimesHeight = 32.0;  // below the last curve
constexpr double kTickGap = 5.0;

QString tickText(double value) {
  return QString::number(std::abs(value) < 1e-12 ? 0.0 : value, 'g', 6);
}

}  // namespace

double niceStep(double length, int most) {
  const double least = length / std::max(1, most);
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double nice : {1.0, 2.0, 5.0}) {
    if (nice * power >= least * (1.0 - 1e-9)) {
      return nice * power;
    }
  }
  return 10.0 * power;
}

/// Starts at 0 if the values are near it; extends to whole steps.
MetricPlot::Axis MetricPlot::axisOf(const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values) {
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (low > high) {
    return {};
  }
  if (low > 0.0 && low < 0.6 * high) {
    low = 0.0;
  }
  if (high - low < 1e-9) {
    low = std::min(low, 0.0);
    high = high > low ? high : low + 1.0;
  }
  Axis axis;
  axis.step = niceStep(high - low, 4);
  axis.low = axis.step * std::floor(low / axis.step + 1e-9);
  axis.high = axis.step * std::ceil(high / axis.step - 1e-9);
  return axis;
}

MetricPlot::MetricPlot(std::vector<PlotCurve> curves, const PictureLayout& layout, QString caption)
    : curves_(std::move(curves)),
      sizes_(layout.width),
      text_(layout.textAsOutlines),
      caption_(std::move(caption)) {
  const QFontMetricsF metrics(text_.theme().figureFont(8.0));
  first_ = std::numeric_limits<double>::infinity();
  last_ = -first_;
  for (const PlotCurve& curve : curves_) {
    const Axis axis = axisOf(curve.values);
    for (const double tick : editor::multiplesIn(axis.low, axis.high + 1e-9, axis.step)) {
      left_ = std::max(left_, metrics.horizontalAdvance(tickText(tick)));
    }
    if (!curve.times.empty()) {
      first_ = std::min(first_, curve.times.front());
      last_ = std::max(last_, curve.times.back());
    }
  }
  if (!(last_ > first_)) {
    first_ = std::isfinite(first_) ? first_ : 0.0;
    last_ = first_ + 1.0;
  }
  left_ += sizes_.margin() + kTickGap;
  const double panel = sizes_.isNarrow ? kPanelHeight : kWidePanel;
  const double foot = caption_.isEmpty() ? 0.0 : sizes_.row();
  size_ = QSizeF(layout.width,
                 std::ceil(2.0 * sizes_.margin() + kTimesHeight + foot +
                           static_cast<double>(curves_.size()) * (panel + kCurveTitle + 6.0)));
}

QRectF MetricPlot::frameOf(std::size_t curve) const {
  const double panel = sizes_.isNarrow ? kPanelHeight : kWidePanel;
  const double top =
      sizes_.margin() + kCurveTitle + static_cast<double>(curve) * (panel + kCurveTitle + 6.0);
  return {left_, top, size_.width() - left_ - sizes_.margin() - 8.0, panel};
}

void MetricPlot::paint(QPainter& painter, std::optional<double> at) const {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF(QPointF(), size_), Qt::white);
  const editor::Theme& theme = text_.theme();
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const PlotCurve& curve = curves_[k];
    const QRectF frame = frameOf(k);
    const Axis axis = axisOf(curve.values);
    paintGrid(painter, frame, axis);
    if (at && *at >= first_ && *at <= last_) {
      const double x = frame.left() + (*at - first_) / (last_ - first_) * frame.width();
      painter.setPen(QPen(theme.color(Role::Accent), 1.0));
      painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
    }
    paintCurve(painter, frame, axis, curve);
    const QPointF title(frame.left(), frame.top() - 6.0);
    const QFont strong = theme.font(8.0, QFont::DemiBold);
    text_.write(painter, title, strong, Role::Text, curve.name);
    if (!curve.unit.isEmpty()) {
      const double after = QFontMetricsF(strong).horizontalAdvance(curve.name) + 5.0;
      text_.write(painter, title + QPointF(after, 0.0), theme.font(8.0), Role::TextSecondary,
                  QStringLiteral("[%1]").arg(curve.unit));
    }
  }
  paintTimes(painter, frameOf(curves_.size() - 1));
  if (!caption_.isEmpty()) {
    text_.write(painter, {left_, size_.height() - sizes_.margin()}, theme.font(8.0),
                Role::TextSecondary, caption_);
  }
}

void MetricPlot::paintGrid(QPainter& painter, const QRectF& frame, const Axis& axis) const {
  const editor::Theme& theme = text_.theme();
  const QFont font = theme.figureFont(8.0);
  const QFontMetricsF metrics(font);
  for (const double tick : editor::multiplesIn(axis.low, axis.high + 1e-9, axis.step)) {
    const double y = frame.bottom() - (tick - axis.low) / (axis.high - axis.low) * frame.height();
    painter.setPen(QPen(theme.color(Role::Line), 0.8));
    painter.drawLine(QPointF(frame.left(), y), QPointF(frame.right(), y));
    const QString labelText = tickText(tick);
    text_.write(painter,
                {frame.left() - kTickGap - metrics.horizontalAdvance(labelText),
                 y + 0.5 * metrics.capHeight()},
                font, Role::Text, labelText);
  }
}

void MetricPlot::paintTimes(QPainter& painter, const QRectF& frame) const {
  const editor::Theme& theme = text_.theme();
  const QFont font = theme.figureFont(8.0);
  const QFontMetricsF metrics(font);
  const double step = niceStep(last_ - first_, std::max(2, static_cast<int>(frame.width() / 60.0)));
  painter.setPen(QPen(theme.color(Role::Text), 0.8));
  painter.drawLine(frame.bottomLeft(), frame.bottomRight());
  for (const double tick : editor::multiplesIn(first_ - 1e-9, last_ + 1e-9, step)) {
    const double x = frame.left() + (tick - first_) / (last_ - first_) * frame.width();
    painter.setPen(QPen(theme.color(Role::Text), 0.8));
    painter.drawLine(QPointF(x, frame.bottom()), QPointF(x, frame.bottom() + 3.0));
    const QString labelText = tickText(tick);
    text_.write(
        painter,
        {x - 0.5 * metrics.horizontalAdvance(labelText), frame.bottom() + 4.0 + metrics.ascent()},
        font, Role::Text, labelText);
  }
  const QString labelText = QStringLiteral("time [s]");
  text_.write(painter,
              {frame.right() - metrics.horizontalAdvance(labelText),
               frame.bottom() + 5.0 + 2.0 * metrics.ascent() + 2.0},
              theme.font(8.0), Role::TextSecondary, labelText);
}

void MetricPlot::paintCurve(QPainter& painter, const QRectF& frame, const Axis& axis,
                            const PlotCurve& curve) const {
  painter.setPen(QPen(text_.theme().line(editor::Look::Regular), sizes_.line(), Qt::SolidLine,
                      Qt::RoundCap, Qt::RoundJoin));
  QPolygonF line;
  const auto end = std::min(curve.times.size(), curve.values.size());
  for (std::size_t k = 0; k <= end; ++k) {
    const bool isThere = k < end && std::isfinite(curve.values[k]);
    if (isThere) {
      line << QPointF(
          frame.left() + (curve.times[k] - first_) / (last_ - first_) * frame.width(),
          frame.bottom() - (curve.values[k] - axis.low) / (axis.high - axis.low) * frame.height());
    } else {
      if (line.size() == 1) {
        painter.drawPoint(line.front());
      } else if (!line.isEmpty()) {
        painter.drawPolyline(line);
      }
      line.clear();
    }
  }
}

}  // namespace app
