#include <algorithm>
#include <cmath>

#include "app/report/Tables.h"
#include "metrics/statistics/Ranks.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

std::size_t runsOf(const Study& study, std::size_t option) {
  return static_cast<std::size_t>(std::count(study.optionOf.begin(), study.optionOf.end(), option));
}

/// The number of runs with a value, if some have none.
std::string countNote(const Study& study, const Estimate& estimate, std::size_t option) {
  const std::size_t runs = runsOf(study, option);
  return static_cast<std::size_t>(estimate.count()) < runs
             ? "n = " + std::to_string(estimate.count())
             : std::string();
}

/// The decimals of a column: the most that one of its values has, but at most five significant
/// digits of the largest value.
int decimalsOfColumn(const MetricComparison& comparison, bool median) {
  int most = 0;
  int least = 0;  // of the largest value
  double largest = 0.0;
  for (const Estimate& estimate : comparison.estimates) {
    const double value = median ? estimate.median : estimate.mean;
    if (std::isnan(value)) {
      continue;
    }
    const int decimals = decimalsFor(value, median ? estimate.medianInterval : estimate.interval);
    most = std::max(most, decimals);
    if (std::abs(value) > largest) {
      largest = std::abs(value);
      least = decimals;
    }
  }
  constexpr int kAfterFirst = 4;
  const int allowed =
      largest > 0.0 ? kAfterFirst - static_cast<int>(std::floor(std::log10(largest))) : most;
  return std::min(most, std::max(least, allowed));
}

Table::Cell estimateCell(const Study& study, const MetricComparison& comparison, std::size_t option,
                         bool median) {
  const Metric& metric = study.metrics[comparison.metric];
  const Estimate& estimate = comparison.estimates[option];
  const double value = median ? estimate.median : estimate.mean;
  const Interval& interval = median ? estimate.medianInterval : estimate.interval;
  const int decimals = decimalsOfColumn(comparison, median);
  Table::Cell cell;
  cell.text = estimateText(metric, value, decimals);
  cell.below = estimate.isConstant ? kConstant : estimateInterval(metric, interval, decimals);
  cell.note = countNote(study, estimate, option);
  cell.sort = std::isnan(value) ? "–" : base::formatDouble(value);
  cell.bold = !median && comparison.isBestOrTied(option);
  cell.mark = !median && comparison.relativeToBest[option] == RelativeToBest::Worse ? "†" : "";
  return cell;
}

/// The composite per option: the weighted, normalized means. Undefined for options that never
/// succeed.
Numbers compositeOf(const Study& study,
                    const std::vector<std::pair<std::string, double>>& weights) {
  std::vector<statistics::Criterion> criteria;
  const std::vector<bool> succeeds = succeedingOptions(study);
  for (const auto& [key, weight] : weights) {
    const std::size_t metric = study.results.keyAt(key);
    std::vector<Numbers> values(study.options.size());
    for (std::size_t run = 0; run < study.runCount(); ++run) {
      const double value = valueOf(study, metric, run);
      if (!std::isnan(value) && succeeds[study.optionOf[run]]) {
        values[study.optionOf[run]].push_back(value);
      }
    }
    statistics::Criterion criterion;
    for (const Numbers& each : values) {
      criterion.values.push_back(statistics::mean(each));
    }
    criterion.sense =
        study.metrics[metric].sense > 0 ? statistics::Sense::Higher : statistics::Sense::Lower;
    criterion.weight = weight;
    criteria.push_back(std::move(criterion));
  }
  return statistics::composite(criteria);
}

std::string weightsText(const std::vector<std::pair<std::string, double>>& weights) {
  std::vector<std::string> words;
  words.reserve(weights.size());
  for (const auto& [key, weight] : weights) {
    words.push_back(key + " " + base::formatDouble(weight));
  }
  return base::join(words, ", ");
}

/// Explains "constant"; empty without such a cell.
std::string constantText(const Comparisons& comparisons) {
  for (const MetricComparison& comparison : comparisons) {
    if (std::any_of(comparison.estimates.begin(), comparison.estimates.end(),
                    [](const Estimate& estimate) { return estimate.isConstant; })) {
      return " Constant: all runs have this value, so there is no interval.";
    }
  }
  return {};
}

/// "Success 12 %, Path length [m] 0.62": the largest of the differences that the listed pairs of a
/// metric can detect. Empty if there are none.
std::string detectableText(const Study& study, const Comparisons& comparisons) {
  std::vector<std::string> words;
  for (const MetricComparison& comparison : comparisons) {
    double most = statistics::kUndefined;
    for (const PairResult* pair : shownPairs(comparison)) {
      most = std::isnan(most) ? pair->detectable : std::max(most, pair->detectable);
    }
    const Metric& metric = study.metrics[comparison.metric];
    if (!std::isnan(most)) {
      words.push_back(titleOf(metric) + " " + estimateText(metric, most, decimalsFor(most)));
    }
  }
  return base::join(words, ", ");
}

/// Whether the table omits a metric: no run has a value other than 0. Success, and what the user
/// has chosen, is always shown.
bool isOmitted(const Study& study, const MetricComparison& comparison) {
  const Metric& metric = study.metrics[comparison.metric];
  return !study.hasChosenMetrics && !(metric.isRate && metric.sense > 0) &&
         std::all_of(comparison.estimates.begin(), comparison.estimates.end(),
                     [](const Estimate& estimate) {
                       return std::all_of(estimate.values.begin(), estimate.values.end(),
                                          [](double value) { return value == 0.0; });
                     });
}

/// The comparisons that a table shows; the names of the others.
Comparisons columnsOf(const Study& study, const Comparisons& comparisons,
                      std::vector<std::string>& omitted) {
  Comparisons shown;
  for (const MetricComparison& comparison : comparisons) {
    if (isOmitted(study, comparison)) {
      omitted.push_back(study.metrics[comparison.metric].name);
    } else {
      shown.push_back(comparison);
    }
  }
  return shown;
}

}  // namespace

Table resultsTable(const Study& study, const Comparisons& comparisons,
                   const std::vector<std::pair<std::string, double>>& weights) {
  Table table;
  table.name = "results";
  table.columns = {{comparedName(study), {}, false}, {"Runs", {}, true}};
  std::vector<std::string> omitted;
  const Comparisons shown = columnsOf(study, comparisons, omitted);
  for (const MetricComparison& comparison : shown) {
    const Metric& metric = study.metrics[comparison.metric];
    table.columns.push_back({metric.name, metric.unit == "-" ? "" : metric.unit, true});
  }
  const Numbers composite = compositeOf(study, weights);
  if (!weights.empty()) {
    table.columns.push_back({"Composite", {}, true});
  }
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    std::vector<Table::Cell> row = {{study.options[option]},
                                    {std::to_string(runsOf(study, option))}};
    for (const MetricComparison& comparison : shown) {
      row.push_back(estimateCell(study, comparison, option, false));
    }
    if (!weights.empty()) {
      row.push_back({numberText(composite[option], 2)});
    }
    table.rows.push_back(std::move(row));
  }
  table.caption =
      "Means (for rates: shares of runs) with confidence intervals, level " +
      levelText(study.level) + "." + constantText(shown) +
      (omitted.empty() ? std::string()
                       : " 0 or undefined in all runs: " + base::join(omitted, ", ") + ".");
  if (study.options.size() > 1) {
    table.caption +=
        " Bold: best. †: significantly worse than the best on the same cases and seeds (p < 0.05, "
        "adjusted with Holm's method over " +
        allTests(testCounts(comparisons).pairs) + ").";
    const auto hasFailure = [](const MetricComparison& each) {
      return std::find(each.succeeds.begin(), each.succeeds.end(), false) != each.succeeds.end();
    };
    if (std::any_of(comparisons.begin(), comparisons.end(), hasFailure)) {
      table.caption += " Options that never succeed are never marked as best.";
    }
    const std::string detectable = detectableText(study, comparisons);
    if (!detectable.empty()) {
      table.caption +=
          " Smallest differences that pairs of these runs can detect (power 80 %): " + detectable +
          ".";
    }
  }
  if (!weights.empty()) {
    table.caption += " Composite score with weights: " + weightsText(weights) +
                     "; each metric is scaled from 0 (worst option) to 1 (best option).";
  }
  return table;
}

std::optional<Table> mediansTable(const Study& study, const Comparisons& comparisons) {
  Table table;
  table.name = "medians";
  table.columns = {{comparedName(study), {}, false}};
  for (const std::string& option : study.options) {
    table.rows.push_back({{option}});
  }
  for (const MetricComparison& comparison : comparisons) {
    const Metric& metric = study.metrics[comparison.metric];
    if (metric.isRate || isOmitted(study, comparison)) {
      continue;
    }
    table.columns.push_back({metric.name, metric.unit == "-" ? "" : metric.unit, true});
    for (std::size_t option = 0; option < study.options.size(); ++option) {
      table.rows[option].push_back(estimateCell(study, comparison, option, true));
    }
  }
  table.caption = "Medians with confidence intervals of at least " + levelText(study.level) +
                  " between order statistics.";
  return table.columns.size() > 1 ? std::optional(std::move(table)) : std::nullopt;
}

}  // namespace report
