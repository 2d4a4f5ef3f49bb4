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

/// The metric that grades failures: the share of the distance to the goal that is left.
constexpr char kRemainingKey[] = "goal_traversal_ratio";

/// What counts of a run.
struct TuneOutcome {
  bool isSuccess = false;
  double simulated = 0.0;      // duration [s]
  std::vector<double> values;  // per objective; NaN: undefined
  double remaining = 1.0;      // share of the distance to the goal at the end, in [0, 1]

  /// 0 for a success, otherwise 0.5 (failed at the goal) to 1 (did not come nearer). Values that
  /// never succeed are comparable by it.
  double severity() const { return isSuccess ? 0.0 : 0.5 + 0.5 * remaining; }
};
using TuneOutcomes = std::vector<TuneOutcome>;
/// Values of a run without success are undefined, except success itself: the run is incomplete.
TuneOutcome outcomeOf(const ResultRow& row, const std::vector<TuneObjective>& objectives);

/// Some values compared with reference values, on the same runs.
struct TuneScore {
  /// Per objective: 1 + change / reference value, in the direction in which smaller is better; 0.9
  /// is an improvement by 10 %. A reference value of 0 counts as 1.
  std::vector<double> ratios;
  double failures = 0.0, failuresBefore = 0.0;  // share of the runs
  double failureError = 0.0;                    // standard error of their difference, paired
  double total = 0.0;                           // smaller is better; the reference: 1
  double error = 0.0;                           // standard error of the total, paired

  /// Not more failures than before by more than a standard error, and no objective worse by more
  /// than this share.
  bool isAcceptable(double maxLoss) const;
};

/// Compares runs with those of reference values, which define the scales.
class TuneScoring {
 public:
  /// `reference`: outcomes of all runs with the reference values.
  TuneScoring(std::vector<TuneObjective> objectives, double maxLoss, const TuneOutcomes& reference);

  /// Scores the outcomes of the same runs. The total is the weighted mean of the ratios, plus the
  /// difference of the mean severities of failures, plus 5 times the loss beyond the accepted one
  /// and 3 times the increase of the share of failures. The last two count only what exceeds a
  /// standard error: with few runs, chance exceeds any limit, and the penalties would hide the
  /// differences between candidates. An undefined time of a run counts as its duration, at least as
  /// the time of the other run and twice the mean time of the reference (as PAR2 of algorithm
  /// configuration, but bounded; Hutter et al. 2009, JAIR 36); other undefined values exclude the
  /// pair.
  TuneScore score(const TuneOutcomes& tuned, const TuneOutcomes& reference) const;

  const std::vector<TuneObjective>& objectives() const { return objectives_; }

 private:
  /// In the direction in which smaller is better, in units of the reference value.
  double changeOf(const TuneOutcome& tuned, const TuneOutcome& reference,
                  std::size_t objective) const;
  double timeOf(const TuneOutcome& run, const TuneOutcome& other, std::size_t objective) const;

  std::vector<TuneObjective> objectives_;
  double maxLoss_;
  double weights_ = 0.0;  // their sum
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
