#pragma once

#include <vector>

#include "metrics/statistics/SuccessRates.h"
#include "metrics/statistics/Summary.h"

/// Tests on paired differences of two options that ran on the same seeds.
namespace statistics {

/// Treatment of zero differences in the signed-rank test.
enum class ZeroRule {
  Pratt,    // ranked, then dropped (Pratt 1959); used in reports
  Wilcoxon  // dropped before ranking (Wilcoxon 1945)
};

struct SignedRank {
  int n = 0;  // non-zero differences
  int zeros = 0;
  double plus = 0.0;     // sum of ranks of positive differences
  double minus = 0.0;    // of negative differences
  double p = 1.0;        // two-sided
  bool isExact = false;  // exact distribution used
};

/// Wilcoxon's signed-rank test, two-sided. Exact for n <= 50 (and 10 000 including zeros): the
/// distribution of signs given the ranks, with or without ties and zeros; otherwise the normal
/// approximation with the variance for ties and zeros and a continuity correction of 0.5 (Hollander
/// & Wolfe 1999, 3.1; Pratt 1959). n = 0: p = 1.
SignedRank signedRank(const Numbers& differences, ZeroRule rule = ZeroRule::Pratt);

/// Two-sided p value of the sign test without zeros (Conover 1999, 3.4). No differences left: 1.
double signTestP(const Numbers& differences);

/// Hodges-Lehmann estimate: median of the means of all pairs of differences, including each with
/// itself (Hodges & Lehmann 1963; Hollander & Wolfe 1999, 3.2). n = 0: NaN.
double pairedShift(const Numbers& differences);
/// Confidence interval of pairedShift() (Hollander & Wolfe 1999, 3.3), from the exact distribution
/// of the signed-rank sum for n <= 50, otherwise from the normal approximation. Ties and zeros are
/// kept. Undefined if n is too small (95 %: n < 6).
Interval pairedShiftInterval(const Numbers& differences, double level = 0.95);

/// Two options on the same seeds of several strata (scenarios): differences are ranked within their
/// stratum, so that the spread of one stratum does not affect another. With one stratum the results
/// are those of Paired.h.

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

/// Interval for the mean difference of paired rates, each stratum weighted by its share of pairs:
/// the intervals of the strata (pairedRateInterval) are combined by the squares of their distances
/// from the estimates (Yan & Su 2010, Stat. Biopharm. Res. 2, 323-335). No pairs: undefined.
Interval stratifiedRateInterval(const std::vector<PairedOutcomes>& strata, double level = 0.95);

}  // namespace statistics
