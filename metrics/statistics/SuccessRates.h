#pragma once

#include "metrics/statistics/Summary.h"

/// Success rates.
namespace statistics {

/// Wilson's score interval without continuity correction (Wilson 1927; method 3 of Newcombe 1998,
/// Statist. Med. 17). n = 0: undefined. For 0 and n successes one end is exactly 0 or 1.
Interval wilsonInterval(int successes, int n, double level = 0.95);

/// Paired outcomes of two options.
struct PairedOutcomes {
  int both = 0, onlyFirst = 0, onlySecond = 0, neither = 0;
  int count() const { return both + onlyFirst + onlySecond + neither; }
};

/// Interval for the difference of rates, first - second, from the Wilson intervals of both and
/// their correlation (method 10 of Newcombe 1998, Statist. Med. 17, 2635-2650). No pairs:
/// undefined.
Interval pairedRateInterval(const PairedOutcomes& outcomes, double level = 0.95);

/// McNemar's exact test (Conover 1999, 3.5): two-sided p value of `onlyFirst` pairs in which only
/// the first succeeds against `onlySecond`; twice the smaller binomial tail, at most 1. No
/// discordant pairs: 1.
double mcNemarP(int onlyFirst, int onlySecond);

}  // namespace statistics
