#pragma once

#include <vector>

#include "metrics/statistics/Rates.h"
#include "metrics/statistics/Summary.h"

/// Two options tried on the same seeds of several strata (scenarios): differences are ranked within
/// their stratum only, so that the spread of one stratum does not affect another. With one stratum
/// the results are those of Paired.h.
namespace statistics {

/// Differences of the pairs, one list per stratum; empty lists are ignored.
using Strata = std::vector<Numbers>;

struct StratifiedSignedRank {
  int strata = 0;  // with pairs
  int n = 0;       // differences that are not zero
  int zeros = 0;
  double p = 1.0;        // two-sided
  bool isExact = false;  // by the exact distribution
};

/// Wilcoxon's signed-rank test (1945; zeros by Pratt's rule, 1959) within each stratum, the sums of
/// ranks added with the weights 1 / (pairs + 1) of van Elteren (1960, Bull. Int. Statist. Inst. 37,
/// 351-361). Exact for n <= 50, with at most 10 000 pairs and small whole weights: all changes of
/// signs given the ranks, ties and zeros or not; else by the normal distribution with the variance
/// of the same and a continuity correction of half the smallest weight. n = 0: p = 1.
StratifiedSignedRank stratifiedSignedRank(const Strata& differences);

/// The typical difference of that test (Hodges & Lehmann 1963): median of the means of all pairs of
/// differences of one stratum, each with itself too, weighted likewise. No differences: NaN.
double stratifiedShift(const Strata& differences);
/// The interval of that difference, from the distribution without ties: exact for up to 50
/// differences, else normal. Undefined where there are too few differences.
Interval stratifiedShiftInterval(const Strata& differences, double level = 0.95);

/// Interval for the mean of the differences of paired rates, each stratum with the share of its
/// pairs: the intervals of the strata (pairedRateInterval) combined as squares of their distances
/// from the estimates (Yan & Su 2010, Stat. Biopharm. Res. 2, 323-335). No pairs: undefined.
Interval stratifiedRateInterval(const std::vector<PairedOutcomes>& strata, double level = 0.95);

}  // namespace statistics
