#pragma once

#include <functional>

#include "metrics/statistics/Summary.h"

/// Functions shared by rank tests.
namespace statistics {

/// Ranks from 1; equal values get the mean of their ranks.
Numbers midranks(const Numbers& values);
/// Σ (t³ - t) over groups of t equal values; 0: no ties.
double tieSum(Numbers values);

/// P(T <= t) for t = 0 … n (n + 1) / 2 of Wilcoxon's signed-rank sum of n differences without ties
/// and zeros under the null hypothesis (Hollander & Wolfe 1999, 3.1). n <= 60.
Numbers signedRankCdf(int n);

/// P(T <= t) for the sum T of ranks that are each included with probability 1/2: the distribution
/// given the ranks, with ties and without the ranks of zeros (Hollander & Wolfe 1999, 3.1, ties).
/// `ranks` are multiples of 0.5; t >= 0.
double signedRankSumCdf(const Numbers& ranks, double t);

/// P(U <= u) for u = 0 … n m of the Mann-Whitney statistic without ties (Hollander & Wolfe 1999,
/// 4.1).
Numbers rankSumCdf(int n, int m);

/// Number of pairs i <= j of sorted numbers with a mean of at most x.
double pairMeansUpTo(const Numbers& sorted, double x);

/// The k-th smallest (from 1) of numbers that are too many to enumerate. `countUpTo(x)` returns how
/// many are at most x. The result lies in [low, high] and is exact.
double orderStatistic(const std::function<double(double)>& countUpTo, double k, double low,
                      double high);

}  // namespace statistics
