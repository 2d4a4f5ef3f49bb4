#pragma once

#include <functional>

#include "metrics/statistics/Summary.h"

/// Ranks and their distributions; comparison of two samples by ranks, and of several options.
namespace statistics {

/// Ranks from 1; equal values get the mean of their ranks.
Numbers midranks(const Numbers& values);

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

/// Cliff's delta (Cliff 1993): the share of pairs in which the first value is larger minus the
/// share in which it is smaller, in [-1, 1]; ties count as neither. NaN for an empty sample.
double cliffsDelta(const Numbers& first, const Numbers& second);

/// Median of all differences first - second (Hodges & Lehmann 1963; Hollander & Wolfe 1999, 4.2).
/// NaN for an empty sample.
double shift(const Numbers& first, const Numbers& second);
/// Confidence interval of shift() (Moses; Hollander & Wolfe 1999, 4.3), from the exact distribution
/// of the rank sum for n + m <= 50, otherwise from the normal approximation. Undefined if the
/// samples are too small for the level.
Interval shiftInterval(const Numbers& first, const Numbers& second, double level = 0.95);

/// p values adjusted by Holm's method (Holm 1979), in the given order, at most 1. Controls the
/// probability of at least one false rejection. NaN is preserved and not counted.
Numbers holm(const Numbers& ps);

/// Friedman test of options ranked within blocks (seeds, data sets).
struct Friedman {
  int blocks = 0, options = 0;
  Numbers meanRanks;        // per option; rank 1: smallest value of its block
  double chiSquared = 0.0;  // with tie correction (Conover 1999, 5.8, T1)
  double p = 1.0;           // for it, options - 1 degrees of freedom
  double f = 0.0;           // Iman & Davenport 1980 (Conover's T2); infinite: all blocks agree
  double fP = 1.0;          // options - 1 and (options - 1) (blocks - 1) degrees of freedom;
                            // f infinite: exact, 1 / (orders of a block)^(blocks - 1) (Conover)
};
/// `blocks[b][o]`: value of option o in block b; all of equal length. Fewer than two blocks or
/// options, or all values within each block equal: p = 1.
Friedman friedman(const std::vector<Numbers>& blocks);

/// Nemenyi's critical difference of mean ranks (Nemenyi 1963; Demšar 2006, 3.2.2): q √(k (k + 1) /
/// (6 N)), q the quantile of the studentized range with infinite degrees of freedom, over √2.
double nemenyiDifference(int options, int blocks, double level = 0.95);

// Comparison of options by several metrics.

enum class Sense { Lower, Higher };  // which direction is better

/// Pareto front: points that no other point dominates, that is, is at least as good in both values
/// and better in one. Equal points are treated equally; points with an undefined value are
/// excluded.
std::vector<bool> paretoFront(const Numbers& x, Sense xSense, const Numbers& y, Sense ySense);

/// Composite score of each option from several metrics with user-defined weights: Σ w s / Σ w in
/// [0, 1], where s is the position of each metric between its worst (0) and best (1) value over the
/// compared options, so it is relative to these options; 1 if all are equal.
struct Criterion {
  Numbers values;  // one per option
  Sense sense = Sense::Lower;
  double weight = 1.0;  // >= 0
};
/// NaN for an option with an undefined value, and for all options if the sum of weights is 0.
Numbers composite(const std::vector<Criterion>& criteria);

}  // namespace statistics
