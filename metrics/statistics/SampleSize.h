#pragma once

#include "metrics/statistics/Summary.h"

/// How many seeds would be enough, from those that were run.
namespace statistics {

struct Power {
  double level = 0.05;  // two-sided
  double power = 0.8;
};

/// Pairs that a paired t test needs to see a mean difference that large: (z + z')² (sd / d)² +
/// z² / 2, rounded up, at least 2 (Guenther 1981, The American Statistician 35). NaN where the
/// difference is zero or a number is undefined; sd = 0: 2.
double pairsForMean(double difference, double standardDeviation, const Power& power = {});

/// Pairs that the signed-rank test needs: (z + z')² / (3 (p' - 1/2)²), rounded up (Noether 1987,
/// JASA 82, equation 8), p' being the chance that the sum of two differences is positive.
/// p' = 1/2 or undefined: NaN.
double pairsForSignedRank(double chancePositive, const Power& power = {});
/// p' estimated: share of pairs of differences with a positive sum, ties half. n < 2: NaN.
double chanceOfPositiveSum(Numbers differences);

}  // namespace statistics
