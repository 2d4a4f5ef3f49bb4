#pragma once

#include "metrics/statistics/Summary.h"

/// Several comparisons at once.
namespace statistics {

/// p values adjusted for all being looked at (Holm 1979), in the order given; at most 1. The chance
/// of one false finding or more stays below a level when those below it are taken. NaN stays NaN
/// and does not count.
Numbers holm(const Numbers& ps);

/// Options ranked within blocks (seeds, data sets).
struct Friedman {
  int blocks = 0, options = 0;
  Numbers meanRanks;        // per option; rank 1 = the smallest value of its block
  double chiSquared = 0.0;  // with the correction for ties (Conover 1999, 5.8, T1)
  double p = 1.0;           // of it, options - 1 degrees of freedom
  double f = 0.0;           // Iman & Davenport 1980 (Conover's T2); infinite: all blocks agree
  double fP = 1.0;          // options - 1 and (options - 1) (blocks - 1) degrees of freedom;
                            // f infinite: exact, 1 / (orders of a block)^(blocks - 1) (Conover)
};
/// `blocks[b][o]`: value of option o in block b; all of one length. Fewer than two blocks or
/// options, or all values of every block equal: no difference, p = 1.
Friedman friedman(const std::vector<Numbers>& blocks);

/// Nemenyi's critical difference of mean ranks (Nemenyi 1963; Demšar 2006, 3.2.2):
/// q √(k (k + 1) / (6 N)), q the quantile of the studentized range, infinite freedom, over √2.
double nemenyiDifference(int options, int blocks, double level = 0.95);
/// p of two mean ranks by it.
double nemenyiP(double meanRank1, double meanRank2, int options, int blocks);

}  // namespace statistics
