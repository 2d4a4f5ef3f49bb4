#include <algorithm>
#include <cmath>

#include "app/report/Markup.h"
#include "app/report/PlotParts.h"
#include "app/report/Plots.h"

namespace report {

namespace {

using Anchor = Figure::Anchor;

constexpr double kPairLetter = 6.2;  // px of a character of the names of pairs
constexpr double kPairGap = 16.0;    // px beside them

/// Width [px] for the names of pairs, including the gap: as the longest name needs, up to `most`.
double pairNamesWidth(const Study& study, const Comparisons& comparisons, double most) {
  std::size_t longest = 0;
  for (const MetricComparison& comparison : comparisons) {
    for (const PairResult* pair : shownPairs(comparison)) {
      longest = std::max(longest, characterCount(study.options[pair->first]) +
                                      characterCount(study.options[pair->second]) + 3);
    }
  }
  return std::clamp(kPairLetter * static_cast<double>(longest) + kPairGap, 150.0, most);
}

/// "dwa − mppi", each with half of the width.
std::string nameOfPair(const Study& study, const PairResult& pair, double width) {
  const auto room = static_cast<std::size_t>((width - kPairGap) / kPairLetter);
  const std::string& first = study.options[pair.first];
  const std::string& second = study.options[pair.second];
  if (characterCount(first) + characterCount(second) + 3 <= room) {
    return first + " − " + second;
  }
  const std::size_t half = room > 5 ? (room - 3) / 2 : 1;
  return shortened(first, half) + " − " + shortened(second, half);
}

/// The place of a panel [px]; `names`: the width of the column with the names of its rows.
struct PanelPlace {
  double left = 0.0, top = 0.0, width = 0.0, names = 0.0;
};

void differencePanel(Figure& figure, const Study& study, const MetricComparison& comparison,
                     const PanelPlace& place) {
  constexpr double kRow = 30.0;
  const auto& [left, top, width, names] = place;
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
  const Scale scale = roomyScale(extent.low, extent.high, left + names, left + width - 8.0);
  double y = top + kTitle + 0.5 * kRow;
  for (const PairResult* pair : pairs) {
    figure.text(left + names - 10.0, y + 4.0, nameOfPair(study, *pair, names), "ink", Anchor::End,
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
  const double names = namesWidth(study, kMostNames * width);
  const Scale scale{1.0, count, left + names + 10.0, left + width - 46.0};
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
    figure.line(left + names, y - 4.0, x, y - 4.0, strokeOf(order[k]), 1.4);
    figure.text(left + names - 8.0, y, nameOfOption(study, order[k], names - 8.0), "ink",
                Anchor::End);
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
  const int columns =
      columnsOfPanels(chosen.size(), pairNamesWidth(study, comparisons, PanelGrid().width));
  Figure figure =
      panels("differences", chosen.size(), kTitle + 30.0 * static_cast<double>(rows) + kAxis,
             columns, [&](Figure& to, std::size_t k, double left, double top, double width) {
               const double names = pairNamesWidth(study, comparisons, kMostNames * width);
               differencePanel(to, study, *chosen[k], {left, top, width, names});
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
                         columnsOfPanels(chosen.size(), namesWidth(study, PanelGrid().width)),
                         [&](Figure& to, std::size_t k, double left, double top, double width) {
                           ranksPanel(to, study, *chosen[k], left, top, width);
                         });
  figure.caption =
      "Mean ranks, 1 is best. Options joined by a bar differ by less than Nemenyi's critical "
      "difference (CD, 5 %).";
  return figure;
}

}  // namespace report
