#pragma once

#include <optional>
#include <vector>

#include "app/report/Study.h"
#include "metrics/statistics/Ranks.h"
#include "metrics/statistics/Summary.h"

namespace report {

using statistics::Interval;

/// Statistics of one metric of one option over all its runs.
struct Estimate {
  Numbers values;     // defined values, in run order
  int successes = 0;  // of a rate
  double mean = statistics::kUndefined, deviation = statistics::kUndefined;
  double median = statistics::kUndefined;
  Interval interval;        // of the mean: BCa; of a rate: Wilson; undefined if isConstant
  Interval medianInterval;  // from order statistics; likewise
  /// Several equal values that are not a rate: nothing shows how much others would differ.
  bool isConstant = false;
  int count() const { return static_cast<int>(values.size()); }
};

/// A paired test of two options on the same blocks (case and seed).
struct PairTest {
  Numbers differences;                    // first - second, per block with both
  int higher = 0, lower = 0;              // number of blocks in which first is higher, lower
  double shift = statistics::kUndefined;  // Hodges-Lehmann; for rates, the difference
  Interval shiftInterval;                 // undefined also if all differences are equal
  /// Number of pairs for 80 % power to find such a difference; smallest difference > 0 that these
  /// pairs find with 80 % power, both at the level 5 %.
  double requiredPairs = statistics::kUndefined, detectable = statistics::kUndefined;
  double p = statistics::kUndefined;         // signed-rank; for rates, McNemar; NaN: no blocks
  double adjusted = statistics::kUndefined;  // Holm-adjusted over all tests of the table
};

/// The test over all cases: differences are ranked within their case (statistics/PairedTests.h).
/// For rates, McNemar's test has one stratum per pair, so it is also valid over all cases.
struct PairResult : PairTest {
  struct CaseResult : PairTest {  // `adjusted`: over the pairs of all cases
    std::size_t number = 0;       // index of the case
    int both = 0;                 // for rates: blocks in which both succeed
  };
  std::size_t first = 0, second = 0;      // option indices
  std::vector<CaseResult> cases;          // cases that have blocks with both
  double delta = statistics::kUndefined;  // Cliff's delta, within cases
};

/// An option compared with the best option of a metric, on the blocks in which both have values.
enum class RelativeToBest {
  NotDifferent,  // no significant difference; also the best itself, or no best
  Worse,         // significantly worse than the best
  Better,        // significantly better, although its overall mean is worse
  NeverSucceeds  // never succeeds: its runs are incomplete and not ranked
};

/// One metric compared over all options.
struct MetricComparison {
  std::size_t metric = 0;                        // index in the study
  std::vector<Estimate> estimates;               // per option
  std::vector<PairResult> pairs;                 // all pairs of options
  std::vector<bool> succeeds;                    // per option: succeeded at least once, or unknown
  std::optional<std::size_t> best;               // option; none: neutral metric, or all equal
  std::vector<RelativeToBest> relativeToBest;    // per option
  std::optional<statistics::Friedman> friedman;  // at least 3 options and 2 complete blocks
  double friedmanAdjusted = statistics::kUndefined;    // p of F, adjusted over all metrics
  double criticalDifference = statistics::kUndefined;  // Nemenyi, of mean ranks

  /// Whether the option is the best or has an equal mean. An option that never succeeds cannot be
  /// the best: the path length and time of its runs are those of incomplete runs.
  bool isBestOrTied(std::size_t option) const {
    return best && succeeds[option] && estimates[option].mean == estimates[*best].mean;
  }
  /// The pair of two options in either order; null: none.
  const PairResult* pairOf(std::size_t a, std::size_t b) const;
};

constexpr double kSignificance = 0.05;

/// Whether there are several values, all equal.
bool areConstant(const Numbers& values);

/// The value of a metric in a run. For a failed run, success and completion are 0; all other values
/// are undefined, because the run is incomplete.
double valueOf(const Study& study, std::size_t metric, std::size_t run);

/// Runs by block (case and seed): one run per option, or runCount() if missing.
std::vector<std::vector<std::size_t>> blocksOf(const Study& study);

/// Per option: whether a run succeeds, or success is unknown for all runs.
std::vector<bool> succeedingOptions(const Study& study);

/// The combinations of option and case in which several seeds gave the same values of every metric
/// (app/run/SeedEffect.h): such runs are not independent. "dwa, cafe".
std::vector<std::string> constantCells(const Study& study);

/// Whether this holds for all combinations of a study of several options: it has only one distinct
/// run of each, and its tests are meaningless.
bool isOneRunPerCell(const Study& study);

/// Compares all options by one metric; p values are adjusted over the tests of this metric.
MetricComparison compare(const Study& study, std::size_t metric,
                         const std::vector<std::vector<std::size_t>>& blocks);
/// Adjusts the p values of several metrics that are displayed in one table over all its tests, and
/// updates the best options.
void adjustTogether(const Study& study, std::vector<MetricComparison>& comparisons);

/// The numbers of tests in the tables of pairs, of pairs per case and of Friedman's test.
struct TestCounts {
  std::size_t pairs = 0, casePairs = 0, friedman = 0;
};
TestCounts testCounts(const std::vector<MetricComparison>& comparisons);

/// The number of decimals of a value: three significant digits, or fewer or more (up to five) so
/// that half of its interval has one or two digits. An undefined or empty interval is ignored.
int decimalsFor(double value, const Interval& interval = {});

}  // namespace report
