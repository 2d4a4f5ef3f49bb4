#include "app/report/Plots.h"

#include <algorithm>
#include <cmath>

#include "app/report/Markup.h"
#include "app/report/PlotParts.h"

namespace report {

namespace {

constexpr std::size_t kFewPairs = 3;  // all are shown

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
  PanelGrid grid;
  grid.count = chosen.size();
  grid.panelHeight = kTitle + 22.0 * static_cast<double>(study.options.size()) + kAxis;
  grid.columns = columnsOfPanels(grid.count, namesWidth(study, grid.width));
  grid.gap = 20.0;
  Figure figure(name, grid.width, grid.height());
  grid.forEach([&](std::size_t k, double left, double top) {
    intervalPanel(figure, study, *chosen[k], left, top, grid.panelWidth());
  });
  return figure;
}

/// Quartiles, median, whiskers to the farthest values within 1.5 quartile distances (Tukey).
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
      strip(figure, values, scale, y + 9.0, 12.0, fillOf(option));
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
  std::optional<Figure> figure = intervalPanels(study, ofKind(study, comparisons, true), "success");
  if (figure) {
    figure->caption = "Rates with Wilson's intervals of " + levelText(study.level) + ".";
  }
  return figure;
}

std::optional<Figure> intervalsFigure(const Study& study, const Comparisons& comparisons) {
  std::optional<Figure> figure =
      intervalPanels(study, ofKind(study, comparisons, false), "intervals");
  if (figure) {
    figure->caption = "Means with bootstrap intervals (BCa) of " + levelText(study.level) + ".";
  }
  return figure;
}

std::optional<Figure> distributionFigure(const Study& study, const Comparisons& comparisons) {
  const auto chosen = ofKind(study, comparisons, false);
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
      "All runs: quartiles and median, whiskers to 1.5 quartile distances; a dot is a run" +
      std::string(isThinned ? " (of many, " + std::to_string(kMostDots) + " evenly chosen by size)."
                            : ".");
  return figure;
}

}  // namespace report
