#pragma once

#include "metrics/statistics/Summary.h"

/// Successes in trials.
namespace statistics {

/// Wilson's score interval without continuity correction (Wilson 1927; method 3 of Newcombe 1998,
/// Statist. Med. 17). n = 0: undefined. 0 and n successes have an end at exactly 0 and 1.
Interval wilsonInterval(int successes, int n, double level = 0.95);

/// Paired outcomes of two options.
struct PairedOutcomes {
  int both = 0, onlyFirst = 0, onlySecond = 0, neither = 0;
  int count() const { return both + onlyFirst + onlySecond + neither; }
};

/// Interval for the difference of the rates, first - second: Wilson's of both put together with
/// their correlation (method 10 of Newcombe 1998, Statist. Med. 17, 2635-2650). No pairs:
/// undefined.
Interval pairedRateInterval(const PairedOutcomes& outcomes, double level = 0.95);

/// McNemar's exact test of paired outcomes (Conover 1999, 3.5): two-sided p of `onlyFirst` pairs in
/// which only the first succeeds against `onlySecond`; twice the smaller binomial tail, at most 1.
/// None of either: 1.
double mcNemarP(int onlyFirst, int onlySecond);

}  // namespace statistics
