#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/report/Markup.h"
#include "app/report/Plots.h"
#include "app/report/RunPictures.h"

/// Comparison tables.
namespace report {

/// Options x metrics: means or rates with intervals, the best in bold, "†" if an option is worse.
/// With `weights`, adds a composite column. Without chosen metrics, those that are 0 or undefined
/// in all runs are only named, except success.
Table resultsTable(const Study& study, const Comparisons& comparisons,
                   const std::vector<std::pair<std::string, double>>& weights);
/// Medians instead of means. Nothing: only rates are displayed.
std::optional<Table> mediansTable(const Study& study, const Comparisons& comparisons);
/// Pairs of options: difference, tests, effect size, required number of pairs.
Table pairsTable(const Study& study, const Comparisons& comparisons, bool all);
/// As pairsTable, per case. Nothing with a single case. `all`: all pairs and rows, otherwise the
/// displayed ones.
std::optional<Table> casePairsTable(const Study& study, const Comparisons& comparisons, bool all);
/// Friedman's test of each metric. Nothing with fewer than three options.
std::optional<Table> familyTable(const Study& study, const Comparisons& comparisons);
/// Failures with their replay command, and a button if the player contains the run.
Table failuresTable(const Study& study, const std::vector<std::size_t>& failures,
                    const std::vector<std::size_t>& played);

/// All metrics per option, and per option and case, as CSV.
std::string allMetricsCsv(const Study& study);

/// A formatted value: "1.50", "93 %".
std::string estimateText(const Metric& metric, double value, int decimals);
/// The interval of a value, likewise: "[1.21, 1.80]".
std::string estimateInterval(const Metric& metric, const Interval& interval, int decimals);
constexpr char kConstant[] = "constant";  // instead of an interval
/// The heading of the options: the compared path.
std::string comparedName(const Study& study);
/// "all 12 tests of this table"
std::string allTests(std::size_t count);

}  // namespace report
