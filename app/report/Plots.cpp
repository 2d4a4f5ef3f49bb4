#include "app/report/Plots.h"

#include <algorithm>
#include <cmath>

#include "app/report/Markup.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

constexpr std::size_t kFewPairs = 3;  // up to this number, all pairs are displayed

/// Draws the option names beside their rows, within this width [px].
void optionNames(Figure& figure, const Study& study, double left, double top, double rowHeight,
                 double width) {
  constexpr double kGap = 10.0;
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    const double y = top + (static_cast<double>(option) + 0.5) * rowHeight;
    figure.text(left + width - kGap, y + 4.0, nameOfOption(study, option, width - kGap), "ink",
                Figure::Anchor::End);
  }
}

/// A panel with one row per option: dot and interval.
void intervalPanel(Figure& figure, const Study& study, const MetricComparison& comparison,
                   double left, double top, double width) {
  constexpr double kRow = 22.0;
  const Metric& metric = study.metrics[comparison.metric];
  panelTitle(figure, titleOf(metric), left, top);
  Extent extent;
  for (const Estimate& estimate : comparison.estimates) {
    extent.add(estimate.mean);
    extent.add(estimate.interval);
  }
  const double right = left + width - 18.0;
  const double names = namesWidth(study, kMostNames * width);
  const Scale scale = metric.isRate ? Scale{0.0, 1.0, left + names, right}
                                    : scaleOfValues(extent, left + names, right);
  optionNames(figure, study, left, top + kTitle, kRow, names);
  const double bottom = top + kTitle + static_cast<double>(study.options.size()) * kRow;
  for (const double tick : axisTicks(scale)) {
    figure.line(scale.at(tick), top + kTitle, scale.at(tick), bottom, "grid");
  }
  for (std::size_t option = 0; option < comparison.estimates.size(); ++option) {
    const Estimate& estimate = comparison.estimates[option];
    const double y = top + kTitle + (static_cast<double>(option) + 0.5) * kRow;
    if (estimate.interval.isDefined()) {
      figure.line(scale.at(estimate.interval.low), y, scale.at(estimate.interval.high), y,
                  strokeOf(option), 2.0);
    }
    if (!std::isnan(estimate.mean)) {
      figure.mark(scale.at(estimate.mean), y, option);
    } else {
      figure.text(scale.from + 4.0, y + 4.0, "no values", "dim");
    }
  }
  horizontalAxis(figure, scale, bottom, metric.isRate);
}

std::optional<Figure> intervalPanels(const Study& study,
                                     const std::vector<const MetricComparison*>& chosen,
                                     const char* name) {
  if (chosen.empty()) {
    return std::nullopt;
  }
  return panels(
      name, chosen.size(), kTitle + 22.0 * static_cast<double>(study.options.size()) + kAxis,
      columnsOfPanels(chosen.size(), namesWidth(study, PanelGrid().width)),
      [&](Figure& figure, std::size_t k, double left, double top, double width) {
        intervalPanel(figure, study, *chosen[k], left, top, width);
      },
      20.0);
}

/// Draws a box plot (Tukey): quartiles, median, whiskers to the farthest values within 1.5
/// interquartile ranges.
void box(Figure& figure, const Numbers& values, const Scale& scale, double y, std::size_t option) {
  const Numbers quartiles = statistics::quantiles(values, {0.25, 0.5, 0.75});
  const double reach = 1.5 * (quartiles[2] - quartiles[0]);
  double low = quartiles[0];
  double high = quartiles[2];
  for (const double value : values) {
    low = value >= quartiles[0] - reach ? std::min(low, value) : low;
    high = value <= quartiles[2] + reach ? std::max(high, value) : high;
  }
  const std::string role = strokeOf(option);
  constexpr double kHalf = 5.0;
  figure.line(scale.at(low), y, scale.at(quartiles[0]), y, role);
  figure.line(scale.at(quartiles[2]), y, scale.at(high), y, role);
  const double left = scale.at(quartiles[0]);
  const double width = std::max(0.5, scale.at(quartiles[2]) - left);
  figure.rect(left, y - kHalf, width, 2.0 * kHalf, fillOf(option), 0.18);
  figure.path("M" + pixel(left) + " " + pixel(y - kHalf) + "h" + pixel(width) + "v" +
                  pixel(2.0 * kHalf) + "h" + pixel(-width) + "Z",
              role);
  figure.line(scale.at(quartiles[1]), y - kHalf, scale.at(quartiles[1]), y + kHalf, role, 2.4);
}

void distributionPanel(Figure& figure, const Study& study, const MetricComparison& comparison,
                       double left, double top, double width) {
  constexpr double kRow = 36.0;
  const Metric& metric = study.metrics[comparison.metric];
  panelTitle(figure, titleOf(metric), left, top);
  Extent extent;
  for (const Estimate& estimate : comparison.estimates) {
    for (const double value : estimate.values) {
      extent.add(value);
    }
  }
  const double names = namesWidth(study, kMostNames * width);
  const Scale scale = scaleOfValues(extent, left + names, left + width - 18.0);
  optionNames(figure, study, left, top + kTitle, kRow, names);
  for (std::size_t option = 0; option < comparison.estimates.size(); ++option) {
    const Numbers& values = comparison.estimates[option].values;
    const double y = top + kTitle + (static_cast<double>(option) + 0.5) * kRow;
    if (!values.empty()) {
      box(figure, values, scale, y - 7.0, option);
      stripPlot(figure, values, scale, y + 9.0, 12.0, fillOf(option));
    }
  }
  horizontalAxis(figure, scale, top + kTitle + static_cast<double>(study.options.size()) * kRow);
}

}  // namespace

std::string titleOf(const Metric& metric) {
  return metric.unit.empty() || metric.unit == "-" ? metric.name
                                                   : metric.name + " [" + metric.unit + "]";
}

std::vector<const PairResult*> shownPairs(const MetricComparison& comparison) {
  std::vector<const PairResult*> pairs;
  for (const PairResult& pair : comparison.pairs) {
    const std::size_t best = comparison.best.value_or(0);
    if (comparison.pairs.size() <= kFewPairs || pair.first == best || pair.second == best) {
      pairs.push_back(&pair);
    }
  }
  return pairs;
}

std::optional<Figure> ratesFigure(const Study& study, const Comparisons& comparisons) {
  std::optional<Figure> figure =
      intervalPanels(study, comparisonsOfKind(study, comparisons, true), "success");
  if (figure) {
    figure->caption =
        "Rates with Wilson confidence intervals, level " + levelText(study.level) + ".";
  }
  return figure;
}

std::optional<Figure> intervalsFigure(const Study& study, const Comparisons& comparisons) {
  std::optional<Figure> figure =
      intervalPanels(study, comparisonsOfKind(study, comparisons, false), "intervals");
  if (figure) {
    figure->caption =
        "Means with bootstrap confidence intervals (BCa), level " + levelText(study.level) + ".";
  }
  return figure;
}

std::optional<Figure> distributionFigure(const Study& study, const Comparisons& comparisons) {
  const auto chosen = comparisonsOfKind(study, comparisons, false);
  if (chosen.empty()) {
    return std::nullopt;
  }
  bool isThinned = false;
  for (const MetricComparison* comparison : chosen) {
    for (const Estimate& estimate : comparison->estimates) {
      isThinned = isThinned || estimate.values.size() > kMostDots;
    }
  }
  Figure figure = panels("distributions", chosen.size(),
                         kTitle + 36.0 * static_cast<double>(study.options.size()) + kAxis,
                         columnsOfPanels(chosen.size(), namesWidth(study, PanelGrid().width)),
                         [&](Figure& to, std::size_t k, double left, double top, double width) {
                           distributionPanel(to, study, *chosen[k], left, top, width);
                         });
  figure.caption =
      "All runs: box plots with quartiles, median and whiskers up to 1.5 interquartile ranges; "
      "each dot is a run" +
      std::string(isThinned
                      ? " (at most " + std::to_string(kMostDots) + ", evenly selected by value)."
                      : ".");
  return figure;
}

namespace {

/// The values to draw as dots.
Numbers dotsOf(Numbers values) {
  if (values.size() <= kMostDots) {
    return values;
  }
  std::sort(values.begin(), values.end());
  Numbers dots;
  dots.reserve(kMostDots);
  for (std::size_t k = 0; k < kMostDots; ++k) {
    dots.push_back(values[k * (values.size() - 1) / (kMostDots - 1)]);
  }
  return dots;
}

/// A deterministic jitter in [-0.5, 0.5] from the golden ratio.
double jitter(std::size_t k) {
  const double turns = static_cast<double>(k) * 0.6180339887498949;
  return turns - std::floor(turns) - 0.5;
}

}  // namespace

void Extent::add(double value) {
  if (!std::isnan(value)) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
}

Scale scaleOfValues(const Extent& values, double from, double to) {
  const bool areZeros = values.low == 0.0 && values.high == 0.0;
  return paddedScale(values.low, areZeros ? 1.0 : values.high, from, to);
}

std::vector<const MetricComparison*> comparisonsOfKind(const Study& study,
                                                       const Comparisons& comparisons, bool rates) {
  std::vector<const MetricComparison*> found;
  for (const MetricComparison& comparison : comparisons) {
    if (study.metrics[comparison.metric].isRate == rates) {
      found.push_back(&comparison);
    }
  }
  return found;
}

double namesWidth(const Study& study, double most) {
  constexpr double kLeast = 104.0;
  constexpr double kGap = 16.0;
  std::size_t longest = 0;
  for (const std::string& option : study.options) {
    longest = std::max(longest, characterCount(option));
  }
  return std::min(std::max(kLeast, kLetter * static_cast<double>(longest) + kGap), most);
}

int columnsOfPanels(std::size_t count, double names) {
  PanelGrid two;
  return count == 1 || names > 0.5 * two.panelWidth() ? 1 : two.columns;
}

std::string nameOfOption(const Study& study, std::size_t option, double room) {
  return shortened(study.options[option], static_cast<std::size_t>(room / kLetter));
}

void panelTitle(Figure& figure, const std::string& title, double left, double top) {
  constexpr std::size_t kTitleLength = 46;
  constexpr double kSize = 11.5;
  figure.text(left, top + 12.0, shortened(title, kTitleLength), "ink", Figure::Anchor::Start,
              kSize);
}

std::string levelText(double level) {
  return base::formatDouble(std::round(1e8 * level) / 1e6) + " %";
}

void stripPlot(Figure& figure, const Numbers& values, const Scale& scale, double y, double height,
               const std::string& role) {
  const Numbers dots = dotsOf(values);
  for (std::size_t k = 0; k < dots.size(); ++k) {
    figure.disc(scale.at(dots[k]), y + jitter(k) * height, 1.6, role, 0.45);
  }
}

}  // namespace report
