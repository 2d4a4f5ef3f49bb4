#include "app/report/TimePlot.h"

#include <algorithm>
#include <cmath>

#include "app/report/Plots.h"

namespace report {

namespace {

constexpr double kTimes = 40.0;    // [px], time axis below the last panel
constexpr double kCaption = 18.0;  // [px]
constexpr double kDigit = 6.4;     // [px], width of a digit at 10 px

/// The vertical axis of a panel.
struct ValueAxis {
  Scale scale;
  std::vector<double> at;  // ticks
};

Extent finiteExtent(const std::vector<double>& values) {
  Extent extent;
  for (const double value : values) {
    if (std::isfinite(value)) {
      extent.add(value);
    }
  }
  return extent;
}

/// Starts at 0 if the values are near it; extends to whole steps.
ValueAxis axisOf(const std::vector<double>& values, double height) {
  constexpr double kWidest = 1e300;
  auto [low, high] = finiteExtent(values);
  if (!(low <= high) || high - low > kWidest) {
    low = 0.0;
    high = 1.0;
  }
  if (low > 0.0 && low < 0.6 * high) {
    low = 0.0;
  }
  if (high - low < 1e-9) {
    low = std::min(low, 0.0);
    high = high > low ? high : low + 1.0;
  }
  const double step = tickStep(high - low, 4);
  low = step * std::floor(low / step + 1e-9);
  high = step * std::ceil(high / step - 1e-9);
  return {{low, high, height, 0.0},
          ticks(low, high, static_cast<int>(std::lround((high - low) / step)))};
}

/// The times of all curves; at least 1 s if they have no duration.
Extent timesOf(const std::vector<TimeCurve>& curves) {
  Extent times;
  for (const TimeCurve& curve : curves) {
    if (!curve.times.empty()) {
      times.add(curve.times.front());
      times.add(curve.times.back());
    }
  }
  if (!(times.high > times.low)) {
    times.low = std::isfinite(times.low) ? times.low : 0.0;
    times.high = times.low + 1.0;
  }
  return times;
}

/// Undefined values are gaps; a value between two gaps is a dot.
void drawCurve(Figure& figure, const TimeCurve& curve, const Scale& across, const Scale& up) {
  std::vector<base::Vec2> line;
  const std::size_t end = std::min(curve.times.size(), curve.values.size());
  for (std::size_t k = 0; k <= end; ++k) {
    if (k < end && std::isfinite(curve.values[k])) {
      line.emplace_back(across.at(curve.times[k]), up.at(curve.values[k]));
      continue;
    }
    if (line.size() == 1) {
      figure.disc(line.front().x(), line.front().y(), 1.0, fillOf(0));
    }
    figure.polyline(line, strokeOf(0), 1.4);
    line.clear();
  }
}

}  // namespace

Figure timePlot(const std::vector<TimeCurve>& curves, double width, const std::string& caption,
                std::optional<double> at) {
  const bool isNarrow = width < 900.0;
  const double margin = isNarrow ? 10.0 : 32.0;
  const double height = isNarrow ? 84.0 : 120.0;
  std::vector<ValueAxis> axes;
  std::size_t digits = 0;
  for (const TimeCurve& curve : curves) {
    axes.push_back(axisOf(curve.values, height));
    for (const std::string& text : tickTexts(axes.back().scale, axes.back().at)) {
      digits = std::max(digits, characterCount(text));
    }
  }
  PanelGrid grid;
  grid.count = curves.size();
  grid.columns = 1;
  grid.panelHeight = kTitle + height;
  grid.gap = 6.0;
  const double left = margin + kDigit * static_cast<double>(digits) + 8.0;
  const double bottom = margin + grid.height();
  const Extent times = timesOf(curves);
  const Scale across{times.low, times.high, left, width - margin - 8.0};
  Figure figure("plot", width, bottom + kTimes + (caption.empty() ? 0.0 : kCaption) + margin);
  grid.forEach([&](std::size_t k, double /*left*/, double above) {
    const TimeCurve& curve = curves[k];
    panelTitle(figure, titleOf({{}, curve.name, curve.unit}), left, margin + above);
    ValueAxis& axis = axes[k];
    const double top = margin + above + kTitle;
    axis.scale.from += top;
    axis.scale.to += top;
    verticalAxis(figure, axis.scale, axis.at, across.from, across.to);
    if (at && *at >= times.low && *at <= times.high) {
      figure.line(across.at(*at), top, across.at(*at), top + height, "accent");
    }
    drawCurve(figure, curve, across, axis.scale);
  });
  horizontalAxis(figure, across, bottom);
  figure.text(across.to, bottom + 30.0, "time [s]", "dim", Figure::Anchor::End, 10.0);
  if (!caption.empty()) {
    figure.text(left, bottom + kTimes + kCaption - 4.0, caption, "dim", Figure::Anchor::Start,
                10.0);
  }
  return figure;
}

}  // namespace report
