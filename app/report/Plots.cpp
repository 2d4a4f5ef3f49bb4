#include "app/report/Plots.h"

#include <algorithm>
#include <cmath>

#include "app/report/Markup.h"
#include "metrics/statistics/Choices.h"

namespace report {

namespace {

using Anchor = Figure::Anchor;

constexpr double kNames = 104.0;  // px for the names of options
constexpr double kTitle = 22.0;   // px above a panel
constexpr double kAxis = 24.0;    // px below it
constexpr std::size_t kNameLength = 17;
constexpr std::size_t kMostDots = 150;  // per strip

/// Smallest and largest of numbers that are defined.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) {
    if (!std::isnan(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  void add(const Interval& interval) {
    add(interval.low);
    add(interval.high);
  }
};

/// The comparisons of one kind of metric.
std::vector<const MetricComparison*> ofKind(const Study& study, const Comparisons& comparisons,
                                            bool rates) {
  std::vector<const MetricComparison*> found;
  for (const MetricComparison& comparison : comparisons) {
    if (study.metrics[comparison.metric].isRate == rates) {
      found.push_back(&comparison);
    }
  }
  return found;
}

std::string percentText(double level) {
  return numberText(100.0 * level, 0) + " %";
}

void optionNames(Figure& figure, const Study& study, double left, double top, double rowHeight) {
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    const double y = top + (static_cast<double>(option) + 0.5) * rowHeight;
    figure.text(left + kNames - 10.0, y + 4.0, shortened(study.options[option], kNameLength), "ink",
                Anchor::End);
  }
}

/// A panel with one row per option: dot and interval.
void intervalPanel(Figure& figure, const Study& study, const MetricComparison& comparison,
                   double left, double top, double width) {
  constexpr double kRow = 22.0;
  const Metric& metric = study.metrics[comparison.metric];
  figure.text(left, top + 12.0, shortened(titleOf(metric), 46), "ink", Anchor::Start, 11.5);
  Extent extent;
  for (const Estimate& estimate : comparison.estimates) {
    extent.add(estimate.mean);
    extent.add(estimate.interval);
  }
  const double right = left + width - 8.0;
  const Scale scale = metric.isRate ? Scale{0.0, 1.0, left + kNames, right}
                                    : roomyScale(extent.low, extent.high, left + kNames, right);
  optionNames(figure, study, left, top + kTitle, kRow);
  const double bottom = top + kTitle + static_cast<double>(study.options.size()) * kRow;
  for (const double tick : ticks(scale.low, scale.high, 4)) {
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
  grid.gap = 20.0;
  Figure figure(name, grid.width, grid.height());
  grid.forEach([&](std::size_t k, double left, double top) {
    intervalPanel(figure, study, *chosen[k], left, top, grid.panelWidth());
  });
  return figure;
}

/// Numbers to place as dots: all of few, else evenly many of the sorted ones.
Numbers dotsOf(Numbers values) {
  if (values.size() <= kMostDots) {
    return values;
  }
  std::sort(values.begin(), values.end());
  Numbers dots;
  for (std::size_t k = 0; k < kMostDots; ++k) {
    dots.push_back(values[k * (values.size() - 1) / (kMostDots - 1)]);
  }
  return dots;
}

/// A place across a strip that looks random and is not: golden ratio.
double scatter(std::size_t k) {
  const double turns = static_cast<double>(k) * 0.6180339887498949;
  return turns - std::floor(turns) - 0.5;
}

void strip(Figure& figure, const Numbers& values, const Scale& scale, double y, double height,
           const std::string& role) {
  const Numbers dots = dotsOf(values);
  for (std::size_t k = 0; k < dots.size(); ++k) {
    figure.disc(scale.at(dots[k]), y + scatter(k) * height, 1.6, role, 0.45);
  }
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
  figure.text(left, top + 12.0, shortened(titleOf(metric), 46), "ink", Anchor::Start, 11.5);
  Extent extent;
  for (const Estimate& estimate : comparison.estimates) {
    for (const double value : estimate.values) {
      extent.add(value);
    }
  }
  const Scale scale = roomyScale(extent.low, extent.high, left + kNames, left + width - 8.0);
  optionNames(figure, study, left, top + kTitle, kRow);
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

void differencePanel(Figure& figure, const Study& study, const MetricComparison& comparison,
                     double left, double top, double width) {
  constexpr double kRow = 30.0;
  const Metric& metric = study.metrics[comparison.metric];
  const auto pairs = shownPairs(comparison);
  figure.text(left, top + 12.0, shortened(titleOf(metric), 46), "ink", Anchor::Start, 11.5);
  Extent extent;
  extent.add(0.0);
  for (const PairResult* pair : pairs) {
    for (const double difference : pair->differences) {
      extent.add(difference);
    }
  }
  constexpr double kPairNames = 1.3 * kNames;
  const Scale scale = roomyScale(extent.low, extent.high, left + kPairNames, left + width - 8.0);
  double y = top + kTitle + 0.5 * kRow;
  for (const PairResult* pair : pairs) {
    const std::string first = shortened(study.options[pair->first], 10);
    const std::string second = shortened(study.options[pair->second], 10);
    figure.text(left + kPairNames - 10.0, y + 4.0, first + " − " + second, "ink", Anchor::End,
                10.5);
    strip(figure, pair->differences, scale, y + 5.0, 10.0, "dim");
    if (pair->shiftInterval.isDefined()) {
      figure.line(scale.at(pair->shiftInterval.low), y - 7.0, scale.at(pair->shiftInterval.high),
                  y - 7.0, "accent", 2.4);
    }
    if (!std::isnan(pair->shift)) {
      figure.disc(scale.at(pair->shift), y - 7.0, 4.0, "heat");
    }
    y += kRow;
  }
  figure.line(scale.at(0.0), top + kTitle, scale.at(0.0), y - 0.5 * kRow, "zero");
  horizontalAxis(figure, scale, y - 0.5 * kRow);
}

/// Groups of options, by ascending rank, within the critical difference; none inside another.
std::vector<std::pair<std::size_t, std::size_t>> undecided(const Numbers& sorted, double critical) {
  std::vector<std::pair<std::size_t, std::size_t>> groups;
  for (std::size_t from = 0; from < sorted.size(); ++from) {
    std::size_t to = from;
    while (to + 1 < sorted.size() && sorted[to + 1] - sorted[from] <= critical) {
      ++to;
    }
    if (to > from && (groups.empty() || groups.back().second < to)) {
      groups.emplace_back(from, to);
    }
  }
  return groups;
}

void ranksPanel(Figure& figure, const Study& study, const MetricComparison& comparison, double left,
                double top, double width) {
  const Metric& metric = study.metrics[comparison.metric];
  const auto count = static_cast<double>(study.options.size());
  figure.text(left, top + 12.0, shortened(metric.name, 40), "ink", Anchor::Start, 11.5);
  figure.text(left + width, top + 12.0, "CD " + numberText(comparison.criticalDifference, 2), "dim",
              Anchor::End, 10.0);
  Numbers ranks = comparison.friedman->meanRanks;  // 1 = the smallest value
  if (metric.sense > 0) {
    for (double& rank : ranks) {
      rank = count + 1.0 - rank;
    }
  }
  std::vector<std::size_t> order(ranks.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    order[k] = k;
  }
  std::stable_sort(order.begin(), order.end(),
                   [&ranks](std::size_t a, std::size_t b) { return ranks[a] < ranks[b]; });
  Numbers sorted;
  for (const std::size_t option : order) {
    sorted.push_back(ranks[option]);
  }
  const Scale scale{1.0, count, left + kNames + 10.0, left + width - 20.0};
  constexpr double kRow = 18.0;
  const double axis = top + kTitle + 20.0;
  figure.line(scale.from, axis, scale.to, axis, "axis");
  for (int rank = 1; rank <= static_cast<int>(count); ++rank) {
    figure.line(scale.at(rank), axis - 4.0, scale.at(rank), axis, "axis");
    figure.text(scale.at(rank), axis - 8.0, std::to_string(rank), "dim", Anchor::Middle, 10.0);
  }
  double y = axis + 10.0;
  for (const auto& [from, to] : undecided(sorted, comparison.criticalDifference)) {
    figure.line(scale.at(sorted[from]) - 3.0, y, scale.at(sorted[to]) + 3.0, y, "line", 3.0);
    y += 6.0;
  }
  y = axis + 10.0 + 6.0 * count;
  for (std::size_t k = 0; k < order.size(); ++k) {
    y += kRow;
    const double x = scale.at(sorted[k]);
    figure.line(x, axis, x, y - 4.0, strokeOf(order[k]));
    figure.line(left + kNames, y - 4.0, x, y - 4.0, strokeOf(order[k]));
    figure.text(left + kNames - 8.0, y, shortened(study.options[order[k]], kNameLength), "ink",
                Anchor::End);
    figure.text(scale.to + 18.0, y, numberText(sorted[k], 2), "dim", Anchor::End, 10.0);
  }
}

/// The comparisons' panels of one kind, two columns.
template <class Draw>
Figure panels(const char* name, std::size_t count, double height, Draw draw) {
  PanelGrid grid;
  grid.count = count;
  grid.panelHeight = height;
  grid.gap = 24.0;
  Figure figure(name, grid.width, grid.height());
  grid.forEach([&](std::size_t k, double left, double top) {
    draw(figure, k, left, top, grid.panelWidth());
  });
  return figure;
}

}  // namespace

std::string titleOf(const Metric& metric) {
  return metric.unit.empty() || metric.unit == "-" ? metric.name
                                                   : metric.name + " [" + metric.unit + "]";
}

std::vector<const PairResult*> shownPairs(const MetricComparison& comparison) {
  constexpr std::size_t kFewPairs = 6;
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
    figure->caption = "Rates with Wilson's intervals of " + percentText(study.level) + ".";
  }
  return figure;
}

std::optional<Figure> intervalsFigure(const Study& study, const Comparisons& comparisons) {
  std::optional<Figure> figure =
      intervalPanels(study, ofKind(study, comparisons, false), "intervals");
  if (figure) {
    figure->caption = "Means with bootstrap intervals (BCa) of " + percentText(study.level) + ".";
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
                         [&](Figure& to, std::size_t k, double left, double top, double width) {
                           distributionPanel(to, study, *chosen[k], left, top, width);
                         });
  figure.caption =
      "All runs: quartiles and median, whiskers to 1.5 quartile distances; a dot is a run" +
      std::string(isThinned ? " (of many, " + std::to_string(kMostDots) + " evenly chosen by size)."
                            : ".");
  return figure;
}

std::optional<Figure> differencesFigure(const Study& study, const Comparisons& comparisons) {
  const auto chosen = ofKind(study, comparisons, false);
  std::size_t rows = 0;
  for (const MetricComparison* comparison : chosen) {
    rows = std::max(rows, shownPairs(*comparison).size());
  }
  if (rows == 0) {
    return std::nullopt;
  }
  Figure figure =
      panels("differences", chosen.size(), kTitle + 30.0 * static_cast<double>(rows) + kAxis,
             [&](Figure& to, std::size_t k, double left, double top, double width) {
               differencePanel(to, study, *chosen[k], left, top, width);
             });
  figure.caption =
      "Differences on the same case and seed (dots), with the typical difference and its "
      "interval of " +
      percentText(study.level) + " (Hodges and Lehmann).";
  return figure;
}

std::optional<Figure> ranksFigure(const Study& study, const Comparisons& comparisons) {
  std::vector<const MetricComparison*> chosen;
  for (const MetricComparison& comparison : comparisons) {
    if (comparison.friedman && study.metrics[comparison.metric].sense != 0) {
      chosen.push_back(&comparison);
    }
  }
  if (chosen.empty()) {
    return std::nullopt;
  }
  Figure figure = panels("ranks", chosen.size(),
                         kTitle + 40.0 + 24.0 * static_cast<double>(study.options.size()),
                         [&](Figure& to, std::size_t k, double left, double top, double width) {
                           ranksPanel(to, study, *chosen[k], left, top, width);
                         });
  figure.caption =
      "Mean ranks, 1 is best. Options joined by a bar differ by less than Nemenyi's critical "
      "difference (CD, 5 %).";
  return figure;
}

std::optional<Figure> paretoFigure(const Study& study, const MetricComparison& x,
                                   const MetricComparison& y) {
  const Metric& metricX = study.metrics[x.metric];
  const Metric& metricY = study.metrics[y.metric];
  Numbers atX;
  Numbers atY;
  Extent extentX;
  Extent extentY;
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    atX.push_back(x.estimates[option].mean);
    atY.push_back(y.estimates[option].mean);
    for (const auto& [extent, estimate] :
         {std::pair(&extentX, &x.estimates[option]), std::pair(&extentY, &y.estimates[option])}) {
      extent->add(estimate->mean);
      extent->add(estimate->interval);
    }
  }
  if (study.options.size() < 2 || extentX.low > extentX.high || extentY.low > extentY.high) {
    return std::nullopt;
  }
  constexpr double kWidth = 720.0;
  constexpr double kHeight = 360.0;
  Figure figure("pareto", kWidth, kHeight);
  const Scale across = roomyScale(extentX.low, extentX.high, 64.0, kWidth - 150.0);
  const Scale up = roomyScale(extentY.low, extentY.high, kHeight - 52.0, 30.0);
  for (const double tick : ticks(up.low, up.high, 5)) {
    figure.line(across.from, up.at(tick), across.to, up.at(tick), "grid");
    figure.text(across.from - 8.0, up.at(tick) + 4.0,
                numberText(tick, tick == std::round(tick) ? 0 : 2), "dim", Anchor::End, 10.0);
  }
  horizontalAxis(figure, across, up.from);
  const auto arrow = [](const Metric& metric, const char* less, const char* more) {
    return metric.sense < 0   ? std::string(" (better ") + less + ")"
           : metric.sense > 0 ? std::string(" (better ") + more + ")"
                              : std::string();
  };
  figure.text(across.to, up.from + 34.0, titleOf(metricX) + arrow(metricX, "←", "→"), "ink",
              Anchor::End);
  figure.text(8.0, 16.0, titleOf(metricY) + arrow(metricY, "↓", "↑"), "ink");
  const auto senseOf = [](const Metric& metric) {
    return metric.sense > 0 ? statistics::Sense::Higher : statistics::Sense::Lower;
  };
  const std::vector<bool> front =
      statistics::paretoFront(atX, senseOf(metricX), atY, senseOf(metricY));
  std::vector<base::Vec2> line;
  for (std::size_t option = 0; option < front.size(); ++option) {
    if (front[option]) {
      line.emplace_back(across.at(atX[option]), up.at(atY[option]));
    }
  }
  std::sort(line.begin(), line.end(),
            [](const base::Vec2& a, const base::Vec2& b) { return a.x() < b.x(); });
  figure.polyline(line, "zero", 1.2);
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    const double px = across.at(atX[option]);
    const double py = up.at(atY[option]);
    if (std::isnan(px) || std::isnan(py)) {
      continue;
    }
    const Interval& wide = x.estimates[option].interval;
    const Interval& high = y.estimates[option].interval;
    if (wide.isDefined()) {
      figure.line(across.at(wide.low), py, across.at(wide.high), py, strokeOf(option));
    }
    if (high.isDefined()) {
      figure.line(px, up.at(high.low), px, up.at(high.high), strokeOf(option));
    }
    figure.mark(px, py, option, 5.5);
    figure.text(px + 9.0, py - 7.0, shortened(study.options[option], 20), "ink");
  }
  figure.caption = titleOf(metricX) + " against " + titleOf(metricY) +
                   ": means with their intervals; the dashed line joins the options that no other "
                   "beats in both.";
  return figure;
}

std::optional<Figure> difficultyFigure(const Study& study, std::size_t metric) {
  const Metric& what = study.metrics[metric];
  struct Row {
    std::size_t ofCase = 0;
    Numbers means;  // per option
    double mean = statistics::kUndefined;
  };
  std::vector<Row> rows(study.cases.size());
  std::vector<std::vector<Numbers>> values(study.cases.size(),
                                           std::vector<Numbers>(study.options.size()));
  for (std::size_t run = 0; run < study.runCount(); ++run) {
    const double value = valueOf(study, metric, run);
    if (!std::isnan(value)) {
      values[study.caseOf[run]][study.optionOf[run]].push_back(value);
    }
  }
  Extent extent;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].ofCase = k;
    Numbers defined;
    for (const Numbers& each : values[k]) {
      rows[k].means.push_back(statistics::mean(each));
      extent.add(rows[k].means.back());
      if (!each.empty()) {
        defined.push_back(rows[k].means.back());
      }
    }
    rows[k].mean = statistics::mean(defined);
  }
  if (rows.size() < 2 || extent.low > extent.high) {
    return std::nullopt;
  }
  const double sign = what.sense > 0 ? 1.0 : -1.0;  // the hardest first
  std::stable_sort(rows.begin(), rows.end(), [sign](const Row& a, const Row& b) {
    return std::isnan(b.mean) ? !std::isnan(a.mean) : sign * a.mean < sign * b.mean;
  });
  constexpr std::size_t kMostRows = 60;
  const bool isCut = rows.size() > kMostRows;
  rows.resize(std::min(rows.size(), kMostRows));
  constexpr double kCaseNames = 250.0;
  constexpr double kRow = 24.0;
  constexpr double kTop = 26.0;
  const double cell =
      std::min(110.0, (720.0 - kCaseNames) / static_cast<double>(study.options.size()));
  Figure figure("difficulty", 720.0, kTop + kRow * static_cast<double>(rows.size()) + 4.0);
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    figure.text(kCaseNames + (static_cast<double>(option) + 0.5) * cell, 16.0,
                shortened(study.options[option], static_cast<std::size_t>(cell / 6.5)), "ink",
                Anchor::Middle);
  }
  const double span = extent.high > extent.low ? extent.high - extent.low : 1.0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double y = kTop + kRow * static_cast<double>(k);
    figure.text(kCaseNames - 10.0, y + 16.0, shortened(study.cases[rows[k].ofCase], 38), "ink",
                Anchor::End);
    for (std::size_t option = 0; option < study.options.size(); ++option) {
      const double mean = rows[k].means[option];
      const double x = kCaseNames + static_cast<double>(option) * cell;
      if (!std::isnan(mean)) {
        const double share = what.isRate ? mean : (mean - extent.low) / span;
        const double hardness = what.sense > 0 ? 1.0 - share : share;
        figure.rect(x + 1.0, y + 1.0, cell - 2.0, kRow - 2.0, "hot", 0.04 + 0.5 * hardness);
      }
      figure.text(x + 0.5 * cell, y + 16.0,
                  what.isRate && !std::isnan(mean) ? numberText(100.0 * mean, 0) + " %"
                                                   : numberText(mean, 2),
                  "ink", Anchor::Middle);
    }
  }
  figure.caption = titleOf(what) + ", mean per case; the hardest first, darker is harder" +
                   (isCut ? " (the first " + std::to_string(kMostRows) + ")." : ".");
  return figure;
}

}  // namespace report
