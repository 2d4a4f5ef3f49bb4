#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/run/ResultRow.h"
#include "metrics/statistics/PairedTests.h"
#include "sim2d/base/Result.h"

/// How runs with tuned values are compared with runs of the values before.
namespace app {

/// A metric that is made smaller, or larger if that is better.
struct TuneObjective {
  std::string key, name, unit;
  double sign = 1.0;    // -1: larger values are better
  double weight = 1.0;  // share in the score, > 0
};
/// "time_to_reach_goal", or with a weight "time_to_reach_goal=2". Errors: unknown metric, a metric
/// without a direction, invalid weight.
base::Result<TuneObjective> tuneObjective(const std::string& text);

/// What counts of a run.
struct TuneOutcome {
  bool isSuccess = false;
  double simulated = 0.0;      // duration [s]
  std::vector<double> values;  // per objective; NaN: undefined
};
using TuneOutcomes = std::vector<TuneOutcome>;
/// Values of a run without success are undefined, except success itself: the run is incomplete.
TuneOutcome outcomeOf(const ResultRow& row, const std::vector<TuneObjective>& objectives);

/// Some values compared with those before, on the same runs.
struct TuneScore {
  /// Per objective: 1 + change / value before, in the direction in which smaller is better; 0.9 is
  /// an improvement by 10 %. A value before of 0 counts as 1.
  std::vector<double> ratios;
  double failures = 0.0, failuresBefore = 0.0;  // share of the runs
  double total = 0.0;                           // smaller is better; before: 1

  /// No more failures than before, and no objective worse by more than this share.
  bool isAcceptable(double maxLoss) const;
};

/// Compares runs. One instance for a study; the values before define the scales.
class TuneScoring {
 public:
  /// `before`: outcomes of all runs with the values before.
  TuneScoring(std::vector<TuneObjective> objectives, double maxLoss, const TuneOutcomes& before);

  /// Scores the outcomes of the runs with these numbers. The total is the weighted mean of the
  /// ratios, plus 5 times the loss beyond the accepted one, plus 3 times the increase of the share
  /// of failures or minus its decrease. An undefined time of a run counts as twice the longer of
  /// the two runs (as PAR2 of algorithm configuration; Hutter et al. 2009, JAIR 36); other
  /// undefined values exclude the pair.
  TuneScore score(const TuneOutcomes& tuned, const TuneOutcomes& before,
                  const std::vector<std::size_t>& runs) const;
  TuneScore score(const TuneOutcomes& tuned, const TuneOutcomes& before) const;  // all runs

  const std::vector<TuneObjective>& objectives() const { return objectives_; }
  double maxLoss() const { return maxLoss_; }

 private:
  std::vector<TuneObjective> objectives_;
  double maxLoss_;
  std::vector<double> scales_;
};

/// A difference, tuned - before, with its paired interval.
struct TuneDifference {
  double before = statistics::kUndefined, after = statistics::kUndefined;  // means, or rates
  double difference = statistics::kUndefined;
  statistics::Interval interval;  // 95 %
  int pairs = 0;                  // with both values
};

/// The difference of an objective over the pairs that have both values, in its own unit. Scenarios
/// are strata: outcome k belongs to scenario k mod `scenarios`.
TuneDifference differenceOf(const TuneOutcomes& tuned, const TuneOutcomes& before,
                            std::size_t objective, std::size_t scenarios);
/// The difference of the success rates.
TuneDifference successDifference(const TuneOutcomes& tuned, const TuneOutcomes& before,
                                 std::size_t scenarios);

}  // namespace app
