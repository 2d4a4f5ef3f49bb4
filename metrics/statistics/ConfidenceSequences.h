#pragma once

#include <utility>
#include <vector>

#include "metrics/statistics/Summary.h"

/// Confidence sequences: intervals for a mean that hold at all sample sizes together, so that a
/// study may evaluate its results at any time and stop as soon as they are sufficient.
namespace statistics {

/// The mean of bounded observations. The bounds of the interval come from bets against each value m
/// of the mean (Waudby-Smith & Ramdas 2024, J. R. Statist. Soc. B 86, 1-27): the wealth
///   W(m) = Σ_k w_k Π_i (1 - θ_k + θ_k (x_i - a) / (m - a)),  x_i in [a, b],
/// a mixture over fixed stakes θ_k (a discrete universal portfolio; Orabona & Jun 2024, IEEE Trans.
/// Inf. Theory 70, 436-455), starts at 1 and is not expected to grow if the mean is m or less. By
/// Ville's inequality it ever reaches 1 / α with probability α or less; the lower bound is the
/// largest m with W(m) >= 1 / α so far. The upper bound mirrors it. No assumption on the
/// distribution beside its bounds.
///
/// Observations come in rounds, one per stratum (scenario) in each. The mean is that over the
/// strata, which may have different means: observations of a round are independent given the
/// earlier rounds, so the expected product of their factors is the product of the expected ones and
/// at most the S-th power of their mean (AM-GM), because the stakes are constant.
class MeanSequence {
 public:
  /// `below`, `above`: the probabilities that the mean is ever below `interval().low`, above
  /// `interval().high`.
  struct Errors {
    double below = 0.025, above = 0.025;
  };
  /// How the first wealth is divided among the stakes θ_k. `Mixed`: narrow intervals of means
  /// anywhere in the range. `MostlyFull`: more than half on the full stake, which decides soonest
  /// where differences from m are on one side (10 % sooner, and 13 % later where they scatter).
  enum class Stakes { Mixed, MostlyFull };
  /// `range`: of the observations, low < high. Values outside count as its ends.
  MeanSequence(const Interval& range, const Errors& errors, Stakes stakes = Stakes::Mixed)
      : range_(range), errors_(errors), stakes_(stakes) {
    interval_ = range;
  }

  /// Adds the observations of one round and narrows the interval.
  void addRound(const Numbers& values);

  int count() const { return count_; }  // observations
  double mean() const;                  // of the observations within the range; none: NaN
  const Interval& interval() const { return interval_; }
  /// log W(m) of the bets that the mean is higher than m, now; `higher` false: lower.
  double logWealth(double m, bool higher) const;

 private:
  void addValue(double value);
  double logGrowth(double share, double m, double end) const;
  double bound(bool higher) const;

  Interval range_;
  Errors errors_;
  Stakes stakes_;
  std::vector<double> single_;                    // values that occurred once
  std::vector<std::pair<double, int>> repeated_;  // others, with their counts
  int count_ = 0;
  double sum_ = 0.0;
  Interval interval_;
};

}  // namespace statistics
