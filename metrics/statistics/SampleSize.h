#pragma once

#include "metrics/statistics/Summary.h"

/// Required numbers of seeds, estimated from completed runs.
namespace statistics {

struct Power {
  double level = 0.05;  // two-sided
  double power = 0.8;
};

/// Pairs required for McNemar's test: (z √d + z' √(d - δ²))² / δ², δ the difference of the shares
/// of pairs in which only the first and only the second succeeds, d their sum (Connor 1987,
/// Biometrics 43), rounded up; at least the number with which the exact test can reach the level, 6
/// for 5 %. Equal or undefined shares: NaN.
double pairsForMcNemar(double onlyFirst, double onlySecond, const Power& power = {});

/// Pairs required for the signed-rank test: (z + z')² / (3 (p' - 1/2)²), rounded up (Noether 1987,
/// JASA 82, equation 8), p' the probability that the sum of two differences is positive. p' = 1/2
/// or undefined: NaN.
double pairsForSignedRank(double chancePositive, const Power& power = {});
/// Estimate of p': share of pairs of differences with a positive sum, ties count half. n < 2: NaN.
double chanceOfPositiveSum(Numbers differences);

}  // namespace statistics
