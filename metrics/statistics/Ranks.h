#pragma once

#include <functional>

#include "metrics/statistics/Summary.h"

/// What tests by ranks share.
namespace statistics {

/// Ranks from 1 on; equal values get the mean of theirs.
Numbers midranks(const Numbers& values);
/// Σ (t³ - t) over groups of t equal values; 0: there are no ties.
double tieSum(Numbers values);

/// P(T <= t) for t = 0 … n (n + 1) / 2 of Wilcoxon's signed-rank sum of n differences without ties
/// and zeros under equal chances of signs (Hollander & Wolfe 1999, 3.1). n <= 60.
Numbers signedRankCdf(int n);

/// P(T <= t) of the sum T of ranks of which each counts or not with equal chances: the distribution
/// given the ranks, with ties and with those of zeros left out (idem 3.1, ties). `ranks` are wholes
/// and halves; t >= 0.
double signedSumAtMost(const Numbers& ranks, double t);

/// P(U <= u) for u = 0 … n m of the count of Mann and Whitney without ties (idem 4.1).
Numbers rankSumCdf(int n, int m);

/// How many pairs i <= j of sorted numbers have a mean of at most x.
double pairMeansUpTo(const Numbers& sorted, double x);

/// The k-th smallest (from 1 on) of numbers that are too many to be listed: `countUpTo(x)` tells
/// how many are at most x. It lies in [low, high]; found exactly.
double orderStatistic(const std::function<double(double)>& countUpTo, double k, double low,
                      double high);

}  // namespace statistics
