#include <algorithm>
#include <cmath>

#include "app/report/Markup.h"
#include "app/report/PlotParts.h"
#include "app/report/Plots.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

using Anchor = Figure::Anchor;

void differencePanel(Figure& figure, const Study& study, const MetricComparison& comparison,
                     double left, double top, double width) {
  constexpr double kRow = 30.0;
  const Metric& metric = study.metrics[comparison.metric];
  const auto pairs = shownPairs(comparison);
  panelTitle(figure, titleOf(metric), left, top);
  Extent extent;
  extent.add(0.0);
  for (const PairResult* pair : pairs) {
    for (const double difference : pair->differences) {
      extent.add(difference);
    }
  }
  constexpr double kPairNames = 1.45 * kNames;
  const Scale scale = roomyScale(extent.low, extent.high, left + kPairNames, left + width - 8.0);
  double y = top + kTitle + 0.5 * kRow;
  for (const PairResult* pair : pairs) {
    const std::string names = base::join(
        {shortened(study.options[pair->first], 11), shortened(study.options[pair->second], 11)},
        " − ");
    figure.text(left + kPairNames - 10.0, y + 4.0, names, "ink", Anchor::End, 10.5);
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
  panelTitle(figure, shortened(metric.name, 40), left, top);
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
  const Scale scale{1.0, count, left + kNames + 10.0, left + width - 46.0};
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
  y = std::max(y, axis + 8.0);
  for (std::size_t k = 0; k < order.size(); ++k) {
    y += kRow;
    const double x = scale.at(sorted[k]);
    figure.line(x, axis, x, y - 4.0, strokeOf(order[k]), 1.4);
    figure.line(left + kNames, y - 4.0, x, y - 4.0, strokeOf(order[k]), 1.4);
    figure.text(left + kNames - 8.0, y, nameOfOption(study, order[k]), "ink", Anchor::End);
    figure.text(left + width, y, numberText(sorted[k], 2), "dim", Anchor::End, 10.0);
  }
}

}  // namespace

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
      levelText(study.level) + " (Hodges and Lehmann).";
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
                         kTitle + 34.0 + 20.0 * static_cast<double>(study.options.size()),
                         [&](Figure& to, std::size_t k, double left, double top, double width) {
                           ranksPanel(to, study, *chosen[k], left, top, width);
                         });
  figure.caption =
      "Mean ranks, 1 is best. Options joined by a bar differ by less than Nemenyi's critical "
      "difference (CD, 5 %).";
  return figure;
}

}  // namespace report
