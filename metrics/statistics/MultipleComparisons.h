#pragma once

#include "metrics/statistics/Summary.h"

/// Multiple comparisons.
namespace statistics {

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
/// (6 N)), q the quantile of the studentized range, infinite freedom, over √2.
double nemenyiDifference(int options, int blocks, double level = 0.95);
/// p value of the difference of two mean ranks by Nemenyi's test.
double nemenyiP(double meanRank1, double meanRank2, int options, int blocks);

}  // namespace statistics
