#pragma once

#include <vector>

#include "metrics/statistics/Summary.h"

/// Tests of two options on the same seeds of one or several strata (scenarios): differences are
/// ranked within their stratum, so that the spread of one stratum does not affect another.
namespace statistics {

/// Paired differences, one list per stratum; empty lists are ignored.
using Strata = std::vector<Numbers>;

struct StratifiedSignedRank {
  int strata = 0;  // non-empty
  int n = 0;       // non-zero differences
  int zeros = 0;
  double p = 1.0;        // two-sided
  bool isExact = false;  // exact distribution used
};

/// Wilcoxon's signed-rank test (1945; zeros by Pratt's rule, 1959) within each stratum; rank sums
/// are added with van Elteren's weights 1 / (pairs + 1) (1960, Bull. Int. Statist. Inst. 37,
/// 351-361). Exact for n <= 50 with at most 10 000 pairs and small integer weights: the
/// distribution of signs given the ranks, with or without ties and zeros; otherwise the normal
/// approximation with the variance of the same and a continuity correction of half the smallest
/// weight. n = 0: p = 1.
StratifiedSignedRank stratifiedSignedRank(const Strata& differences);

/// Hodges-Lehmann estimate for that test (1963): median of the means of all pairs of differences
/// within a stratum, including each with itself, with the same weights. No differences: NaN.
double stratifiedShift(const Strata& differences);
/// Confidence interval of stratifiedShift(), from the distribution without ties: exact for up to 50
/// differences, otherwise normal. Undefined if there are too few differences.
Interval stratifiedShiftInterval(const Strata& differences, double level = 0.95);

/// Student's interval for the mean difference, each stratum weighted by its share of pairs: the
/// variances of the means of the strata are added, with the degrees of freedom of Welch and
/// Satterthwaite (Satterthwaite 1946, Biometrics 2, 110-114). One stratum: meanInterval().
/// Undefined if a stratum has one difference, or there are none.
Interval stratifiedMeanInterval(const Strata& differences, double level = 0.95);

/// Interval for the mean difference of paired rates, each stratum weighted by its share of pairs:
/// the intervals of the strata (pairedRateInterval) are combined by the squares of their distances
/// from the estimates (Yan & Su 2010, Stat. Biopharm. Res. 2, 323-335). No pairs: undefined.
Interval stratifiedRateInterval(const std::vector<PairedOutcomes>& strata, double level = 0.95);

/// Required numbers of seeds, estimated from completed runs.

struct Power {
  double level = 0.05;  // two-sided
  double power = 0.8;
};

/// Pairs required for McNemar's test: (z √d + z' √(d - δ²))² / δ², δ the difference of the shares
/// of pairs in which only the first and only the second succeeds, d their sum (Connor 1987,
/// Biometrics 43), rounded up; at least the number with which the exact test can reach the level, 6
/// for 5 %. Equal or undefined shares: NaN.
double pairsForMcNemar(double onlyFirst, double onlySecond, const Power& power = {});

/// Pairs required for the signed-rank test: (z + z' √(4 p' (1 - p')))² / (3 (p' - 1/2)²), rounded
/// up, p' the probability that the sum of two differences is positive. This is the formula of
/// Noether (1987, JASA 82, equation 8) with a variance that vanishes if p' is 0 or 1, where his
/// cannot give fewer than 11 pairs; at least the number with which the exact test can reach the
/// level, 6 for 5 %. p' = 1/2 or undefined: NaN.
double pairsForSignedRank(double chancePositive, const Power& power = {});
/// The smallest difference of rates that McNemar's test finds with the power: the δ for which
/// pairsForMcNemar() is at most the number of pairs, for this share of pairs that differ, or δ if
/// that is larger. No δ up to 1, or no pairs: NaN.
double detectableRateDifference(double discordant, double pairs, const Power& power = {});
/// The smallest shift that the signed-rank test finds with the power, if differences are normal
/// with this standard deviation: (z + z') σ √(π / (3 n)). That is the shift of the t test divided
/// by the root of the relative efficiency 3 / π (Lehmann 1975, Nonparametrics, 4.3). Too few pairs
/// for the exact test to reach the level, or a deviation of 0, from which the spread cannot be
/// estimated: NaN.
double detectableShift(double deviation, double pairs, const Power& power = {});

/// Estimate of p': share of pairs of differences with a positive sum, ties count half. n < 2: NaN.
double chanceOfPositiveSum(Numbers differences);

}  // namespace statistics
