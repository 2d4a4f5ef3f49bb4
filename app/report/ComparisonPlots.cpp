#include <algorithm>
#include <cmath>

#include "app/report/Markup.h"
#include "app/report/Plots.h"
#include "metrics/statistics/Ranks.h"

namespace report {

namespace {

using Anchor = Figure::Anchor;

statistics::Sense senseOf(const Metric& metric) {
  return metric.sense > 0 ? statistics::Sense::Higher : statistics::Sense::Lower;
}

/// The direction of better values: " (better ←)".
std::string betterText(const Metric& metric, const char* less, const char* more) {
  return metric.sense < 0   ? std::string(" (better ") + less + ")"
         : metric.sense > 0 ? std::string(" (better ") + more + ")"
                            : std::string();
}

/// The scales of two metrics, with axes and titles.
struct Plane {
  Scale across, up;

  void draw(Figure& figure, const Metric& x, const Metric& y) const {
    verticalAxis(figure, up, ticks(up.low, up.high, 5), across.from, across.to);
    horizontalAxis(figure, across, up.from);
    figure.text(across.to, up.from + 34.0, titleOf(x) + betterText(x, "←", "→"), "ink",
                Anchor::End);
    figure.text(8.0, 16.0, titleOf(y) + betterText(y, "↓", "↑"), "ink");
  }
};

/// The labels of options, and the lines that labels should not cover.
struct PlaneMarks {
  std::vector<Label> labels;
  std::vector<Segment> lines;
};

/// Draws the Pareto front.
void drawFront(Figure& figure, const Plane& plane, const std::vector<bool>& front, const Numbers& x,
               const Numbers& y, PlaneMarks& marks) {
  std::vector<base::Vec2> line;
  for (std::size_t option = 0; option < front.size(); ++option) {
    if (front[option]) {
      line.emplace_back(plane.across.at(x[option]), plane.up.at(y[option]));
    }
  }
  std::sort(line.begin(), line.end(),
            [](const base::Vec2& a, const base::Vec2& b) { return a.x() < b.x(); });
  figure.polyline(line, "zero", 1.2);
  for (std::size_t k = 1; k < line.size(); ++k) {
    marks.lines.push_back({line[k - 1], line[k]});
  }
}

void drawOption(Figure& figure, const Plane& plane, std::size_t option, const Estimate& x,
                const Estimate& y, PlaneMarks& marks) {
  const base::Vec2 at(plane.across.at(x.mean), plane.up.at(y.mean));
  const auto draw = [&](const base::Vec2& from, const base::Vec2& to) {
    figure.line(from.x(), from.y(), to.x(), to.y(), strokeOf(option));
    marks.lines.push_back({from, to});
  };
  if (x.interval.isDefined()) {
    draw({plane.across.at(x.interval.low), at.y()}, {plane.across.at(x.interval.high), at.y()});
  }
  if (y.interval.isDefined()) {
    draw({at.x(), plane.up.at(y.interval.low)}, {at.x(), plane.up.at(y.interval.high)});
  }
  figure.mark(at.x(), at.y(), option, 5.5);
}

/// The Pareto-optimal options; options that never succeed are excluded. Empty: a metric has no
/// direction.
std::vector<bool> frontOf(const Study& study, const MetricComparison& x,
                          const MetricComparison& y) {
  const Metric& metricX = study.metrics[x.metric];
  const Metric& metricY = study.metrics[y.metric];
  if (metricX.sense == 0 || metricY.sense == 0) {
    return {};
  }
  Numbers atX;
  Numbers atY;
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    atX.push_back(x.succeeds[option] ? x.estimates[option].mean : statistics::kUndefined);
    atY.push_back(y.estimates[option].mean);
  }
  return statistics::paretoFront(atX, senseOf(metricX), atY, senseOf(metricY));
}

/// What the figure shows of the Pareto front.
std::string frontText(const Study& study, const std::vector<bool>& front) {
  const auto optimal = std::count(front.begin(), front.end(), true);
  if (optimal == 1) {
    const auto only = std::find(front.begin(), front.end(), true) - front.begin();
    return "; " + study.options[static_cast<std::size_t>(only)] +
           " is the only Pareto-optimal option.";
  }
  return optimal > 1 ? "; the dashed line connects the Pareto-optimal options." : ".";
}

/// Draws the options with their names, and the Pareto front.
void drawOptions(Figure& figure, const Plane& plane, const Study& study, const MetricComparison& x,
                 const MetricComparison& y) {
  Numbers atX;
  Numbers atY;
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    atX.push_back(x.estimates[option].mean);
    atY.push_back(y.estimates[option].mean);
  }
  PlaneMarks marks;
  drawFront(figure, plane, frontOf(study, x, y), atX, atY, marks);
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    if (!std::isnan(atX[option]) && !std::isnan(atY[option])) {
      drawOption(figure, plane, option, x.estimates[option], y.estimates[option], marks);
      marks.labels.push_back({nameOfOption(study, option, 260.0),
                              {plane.across.at(atX[option]), plane.up.at(atY[option])}});
    }
  }
  const Box room{{plane.across.from + 2.0, 22.0}, {plane.across.to + 130.0, plane.up.from - 2.0}};
  drawLabels(figure, marks.labels, placeLabels(marks.labels, marks.lines, room));
}

/// The means of a metric in one case, per option.
struct CaseRow {
  std::size_t ofCase = 0;
  Numbers means;                         // NaN: no values
  double mean = statistics::kUndefined;  // mean over the options
};

std::vector<CaseRow> caseRows(const Study& study, std::size_t metric) {
  std::vector<std::vector<Numbers>> values(study.cases.size(),
                                           std::vector<Numbers>(study.options.size()));
  for (std::size_t run = 0; run < study.runCount(); ++run) {
    const double value = valueOf(study, metric, run);
    if (!std::isnan(value)) {
      values[study.caseOf[run]][study.optionOf[run]].push_back(value);
    }
  }
  std::vector<CaseRow> rows(study.cases.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].ofCase = k;
    Numbers defined;
    for (const Numbers& each : values[k]) {
      rows[k].means.push_back(statistics::mean(each));
      if (!each.empty()) {
        defined.push_back(rows[k].means.back());
      }
    }
    rows[k].mean = statistics::mean(defined);
  }
  const double sign = study.metrics[metric].sense > 0 ? 1.0 : -1.0;  // hardest first
  std::stable_sort(rows.begin(), rows.end(), [sign](const CaseRow& a, const CaseRow& b) {
    return std::isnan(b.mean) ? !std::isnan(a.mean) : sign * a.mean < sign * b.mean;
  });
  return rows;
}

constexpr std::size_t kCaseLength = 38;

/// Draws a cell of the difficulty table, shaded by difficulty.
void drawCell(Figure& figure, const Metric& metric, const Extent& extent, double mean,
              const base::Vec2& corner, const base::Vec2& size) {
  if (!std::isnan(mean)) {
    const double span = extent.high > extent.low ? extent.high - extent.low : 1.0;
    const double share = metric.isRate ? mean : (mean - extent.low) / span;
    const double hardness = metric.sense > 0 ? 1.0 - share : share;
    figure.rect(corner.x() + 1.0, corner.y() + 1.0, size.x() - 2.0, size.y() - 2.0, "hot",
                0.04 + 0.5 * hardness);
  }
  const bool asPercent = metric.isRate && !std::isnan(mean);
  figure.text(corner.x() + 0.5 * size.x(), corner.y() + 16.0,
              asPercent ? percentText(mean) : numberText(mean, 2), "ink", Anchor::Middle);
}

}  // namespace

std::optional<Figure> paretoFigure(const Study& study, const MetricComparison& x,
                                   const MetricComparison& y) {
  const Metric& metricX = study.metrics[x.metric];
  const Metric& metricY = study.metrics[y.metric];
  const Extent wide = extentOf(x);
  const Extent high = extentOf(y);
  if (study.options.size() < 2 || wide.isEmpty() || high.isEmpty()) {
    return std::nullopt;
  }
  constexpr double kWidth = 720.0;
  constexpr double kHeight = 360.0;
  Figure figure("pareto", kWidth, kHeight);
  const Plane plane{scaleOfValues(wide, 64.0, kWidth - 130.0),
                    scaleOfValues(high, kHeight - 52.0, 34.0)};
  plane.draw(figure, metricX, metricY);
  drawOptions(figure, plane, study, x, y);
  const std::vector<bool> front = frontOf(study, x, y);
  figure.caption = titleOf(metricX) + " versus " + titleOf(metricY) +
                   ": means with confidence intervals, level " + levelText(study.level) +
                   frontText(study, front) +
                   (!front.empty() && std::count(x.succeeds.begin(), x.succeeds.end(), false) > 0
                        ? " Options that never succeed are excluded from it."
                        : "");
  return figure;
}

std::optional<Figure> difficultyFigure(const Study& study, std::size_t metric) {
  const Metric& what = study.metrics[metric];
  std::vector<CaseRow> rows = caseRows(study, metric);
  Extent extent;
  for (const CaseRow& row : rows) {
    for (const double mean : row.means) {
      extent.add(mean);
    }
  }
  if (rows.size() < 2 || extent.isEmpty()) {
    return std::nullopt;
  }
  constexpr std::size_t kMaxRows = 60;
  const bool isCut = rows.size() > kMaxRows;
  rows.resize(std::min(rows.size(), kMaxRows));
  std::size_t longest = 0;
  for (const CaseRow& row : rows) {
    longest = std::max(longest, shortened(study.cases[row.ofCase], kCaseLength).size());
  }
  const double names = 6.4 * static_cast<double>(longest) + 16.0;
  constexpr double kRow = 24.0;
  constexpr double kLine = 13.0;
  const double cell = std::min(110.0, (720.0 - names) / static_cast<double>(study.options.size()));
  std::vector<std::vector<std::string>> heads;  // wrapped option names
  std::size_t lines = 1;
  for (const std::string& option : study.options) {
    heads.push_back(wrapped(option, static_cast<std::size_t>(std::max(1.0, cell / kLetter))));
    lines = std::max(lines, heads.back().size());
  }
  const double top = 26.0 + kLine * static_cast<double>(lines - 1);
  Figure figure("difficulty", 720.0, top + kRow * static_cast<double>(rows.size()) + 4.0);
  const auto leftOf = [cell, names](std::size_t option) {
    return names + static_cast<double>(option) * cell;
  };
  for (std::size_t option = 0; option < heads.size(); ++option) {
    double y = top - 10.0 - kLine * static_cast<double>(heads[option].size() - 1);
    for (const std::string& line : heads[option]) {
      figure.text(leftOf(option) + 0.5 * cell, y, line, "ink", Anchor::Middle);
      y += kLine;
    }
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double y = top + kRow * static_cast<double>(k);
    figure.text(names - 10.0, y + 16.0, shortened(study.cases[rows[k].ofCase], kCaseLength), "ink",
                Anchor::End);
    for (std::size_t option = 0; option < study.options.size(); ++option) {
      drawCell(figure, what, extent, rows[k].means[option], {leftOf(option), y}, {cell, kRow});
    }
  }
  figure.caption = titleOf(what) +
                   ", mean per case; most difficult case first, more intense colour means more "
                   "difficult" +
                   (isCut ? " (the first " + std::to_string(kMaxRows) + ")." : ".");
  return figure;
}

namespace {

using Anchor = Figure::Anchor;

constexpr double kPairLetter = 6.2;     // [px], character width of pair names
constexpr std::size_t kFewOptions = 3;  // up to this number, all pairs are shown
constexpr double kPairGap = 16.0;       // [px], gap beside pair names

/// The width [px] for the names of pairs, including the gap: that of the longest name, at most
/// `most`.
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

/// The name of a pair, "dwa − mppi"; each name gets half of the width.
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
  const Scale scale = paddedScale(extent.low, extent.high, left + names, left + width - 8.0);
  double y = top + kTitle + 0.5 * kRow;
  for (const PairResult* pair : pairs) {
    figure.text(left + names - 10.0, y + 4.0, nameOfPair(study, *pair, names), "ink", Anchor::End,
                10.5);
    stripPlot(figure, pair->differences, scale, y + 5.0, 10.0, "dim");
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

/// Groups of options, by ascending rank, whose ranks differ by at most the critical difference;
/// none is contained in another.
std::vector<std::pair<std::size_t, std::size_t>> indistinguishableGroups(const Numbers& sorted,
                                                                         double critical) {
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
  Numbers ranks = comparison.friedman->meanRanks;  // 1: smallest value
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
  for (const auto& [from, to] : indistinguishableGroups(sorted, comparison.criticalDifference)) {
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

/// Says that not all differences are drawn.
std::string dotsText(const std::vector<const MetricComparison*>& comparisons) {
  for (const MetricComparison* comparison : comparisons) {
    for (const PairResult* pair : shownPairs(*comparison)) {
      if (pair->differences.size() > kMostDots) {
        return "; at most " + std::to_string(kMostDots) + ", evenly selected by value";
      }
    }
  }
  return {};
}

/// Says that an interval is missing.
std::string fewPairsText(const std::vector<const MetricComparison*>& comparisons) {
  for (const MetricComparison* comparison : comparisons) {
    for (const PairResult* pair : shownPairs(*comparison)) {
      if (!pair->differences.empty() && !pair->shiftInterval.isDefined()) {
        return " Without a bar: too few pairs for an interval of this level, or equal differences.";
      }
    }
  }
  return {};
}

/// Whether a bar connects two options in a panel of ranks.
bool hasGroup(const MetricComparison& comparison) {
  Numbers sorted = comparison.friedman->meanRanks;
  std::sort(sorted.begin(), sorted.end());
  return !indistinguishableGroups(sorted, comparison.criticalDifference).empty();
}

}  // namespace

std::optional<Figure> differencesFigure(const Study& study, const Comparisons& comparisons) {
  const auto chosen = comparisonsOfKind(study, comparisons, false);
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
      "Differences within the same case and seed (small dots" + dotsText(chosen) +
      "), with the Hodges-Lehmann estimate of the difference (large dot) and its confidence "
      "interval (bar), level " +
      levelText(study.level) + "." + fewPairsText(chosen) +
      (study.options.size() > kFewOptions ? " Only pairs with the best option are shown (if there "
                                            "is none, with the first)."
                                          : "");
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
  const bool isAnyGroup = std::any_of(chosen.begin(), chosen.end(),
                                      [](const MetricComparison* each) { return hasGroup(*each); });
  figure.caption =
      isAnyGroup
          ? "Mean ranks; 1 is best. The ranks of options connected by a bar do not differ by more "
            "than Nemenyi's critical difference (CD, level 5 %)."
          : "Mean ranks; 1 is best. All ranks differ by more than Nemenyi's critical difference "
            "(CD, "
            "level 5 %).";
  return figure;
}

}  // namespace report
