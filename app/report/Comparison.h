#pragma once

#include <optional>
#include <vector>

#include "app/report/Study.h"
#include "metrics/statistics/Family.h"
#include "metrics/statistics/Summary.h"

namespace report {

using statistics::Interval;

/// One metric of one option over all its runs.
struct Estimate {
  Numbers values;     // defined ones, in the order of the runs
  int successes = 0;  // of a rate
  double mean = statistics::kUndefined, deviation = statistics::kUndefined;
  double median = statistics::kUndefined;
  Interval interval;        // of the mean: BCa; of a rate: Wilson
  Interval medianInterval;  // by order statistics
  int count() const { return static_cast<int>(values.size()); }
};

/// Two options on the same blocks (case and seed).
struct PairTest {
  Numbers differences;                    // first - second, per block that has both
  int higher = 0, lower = 0;              // blocks in which the first is; the others tie
  double shift = statistics::kUndefined;  // Hodges-Lehmann; of a rate the difference of the rates
  Interval shiftInterval;
  double p = statistics::kUndefined;         // signed-rank, of a rate McNemar; no blocks: none
  double adjusted = statistics::kUndefined;  // by Holm over all pairs of the metric that have one
};

/// Over all cases together: differences are ranked within their case (statistics/Stratified.h); of
/// rates McNemar's test has the pair as its stratum, so that it is also that of the cases together.
struct PairResult : PairTest {
  struct OfCase : PairTest {  // `adjusted`: over the pairs of the metric in this case
    std::size_t number = 0;   // of the case
    int both = 0;             // of a rate: blocks in which both succeed
  };
  std::size_t first = 0, second = 0;            // options
  std::vector<OfCase> cases;                    // that have blocks with both, in their order
  double delta = statistics::kUndefined;        // Cliff's, of values of the same case
  double enoughPairs = statistics::kUndefined;  // for 80 % power with such differences
};

/// An option beside the best of a metric, on the blocks that both have values in.
enum class Standing {
  Close,     // not clearly different; also the best itself, and where there is no best
  Beaten,    // significantly worse
  Ahead,     // significantly better there, although its mean over all runs is not
  NoSuccess  // never succeeds: what its runs measure is of pieces, and is not ranked
};

/// One metric over all options.
struct MetricComparison {
  std::size_t metric = 0;           // place in the study
  std::vector<Estimate> estimates;  // per option
  std::vector<PairResult> pairs;    // of all two options
  std::vector<bool> succeeds;       // per option: once at least, or its success is not known
  std::optional<std::size_t> best;  // option; none: the metric is neutral, or all are equal
  std::vector<Standing> standings;  // per option
  std::optional<statistics::Friedman> friedman;  // three options and two complete blocks or more
  double criticalDifference = statistics::kUndefined;  // of mean ranks, Nemenyi

  /// The best option, and each whose mean equals its. One that never succeeds is no best: its short
  /// way and time are those of a piece.
  bool leads(std::size_t option) const {
    return best && succeeds[option] && estimates[option].mean == estimates[*best].mean;
  }
  /// The pair of two options, whichever comes first; null: there is none.
  const PairResult* pairOf(std::size_t a, std::size_t b) const;
};

constexpr double kSignificance = 0.05;

/// The value of a metric in a run. A failed run succeeds and completes nothing; its other values
/// are those of a piece of a run and are undefined.
double valueOf(const Study& study, std::size_t metric, std::size_t run);

/// Runs by block (case and seed): per option its run, or runCount() where there is none.
std::vector<std::vector<std::size_t>> blocksOf(const Study& study);

/// Per option: one of its runs succeeds, or success is not known of any.
std::vector<bool> succeedingOptions(const Study& study);

/// Options in cases in which several seeds have run and gave equal values of every metric (and at
/// least one value): runs that are not independent.
std::size_t constantCells(const Study& study);

MetricComparison compare(const Study& study, std::size_t metric,
                         const std::vector<std::vector<std::size_t>>& blocks);

/// Decimals with which means are written: half of the narrowest interval is two units or more of
/// the last place.
int decimalsFor(const std::vector<Estimate>& estimates, bool isRate);

}  // namespace report
