#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/report/Markup.h"
#include "app/report/Plots.h"
#include "app/report/RunPictures.h"

/// Tables of a comparison.
namespace report {

/// Options x metrics: means or rates with intervals, the best in bold, "†" where an option is
/// worse; with `weights` a column of the composite.
Table resultsTable(const Study& study, const Comparisons& comparisons,
                   const std::vector<std::pair<std::string, double>>& weights);
/// The same of medians; nothing when only rates are shown.
std::optional<Table> mediansTable(const Study& study, const Comparisons& comparisons);
/// Pairs of options: difference, tests, effect, seeds that would be enough.
Table pairsTable(const Study& study, const Comparisons& comparisons, bool all);
/// The same for each case alone; empty with only one case. `all`: all pairs and rows, else those
/// shown.
std::optional<Table> casePairsTable(const Study& study, const Comparisons& comparisons, bool all);
/// Friedman's test of each metric; nothing with fewer than three options.
std::optional<Table> familyTable(const Study& study, const Comparisons& comparisons);
/// Failures with the command that shows each, and a button where the page can play it.
Table failuresTable(const Study& study, const std::vector<std::size_t>& failures,
                    const std::vector<std::size_t>& played);

/// Every metric per option, and per option and case, as CSV.
std::string allMetricsCsv(const Study& study);

/// "1.50", "93 %".
std::string estimateText(const Metric& metric, double value, int decimals);
/// "[1.21, 1.80]"; undefined: empty.
std::string intervalText(const Metric& metric, const Interval& interval, int decimals);

}  // namespace report
