#pragma once

#include "metrics/statistics/Summary.h"

/// Two options tried on the same seeds: tests on the differences, one per pair.
namespace statistics {

/// What happens to differences of zero in the signed-rank test.
enum class Zeros {
  Pratt,    // ranked with the others, then left out (Pratt 1959); what the report uses
  Wilcoxon  // left out before the ranking (Wilcoxon 1945)
};

struct SignedRank {
  int n = 0;  // differences that are not zero
  int zeros = 0;
  double plus = 0.0;     // sum of the ranks of positive differences
  double minus = 0.0;    // idem, negative
  double p = 1.0;        // two-sided
  bool isExact = false;  // by the exact distribution
};

/// Wilcoxon's signed-rank test, two-sided. Exact for n <= 50 (and 10 000 with the zeros): the
/// distribution of the signs given the ranks, ties and zeros or not; else by the normal one with
/// the variance for ties and zeros and a continuity correction of 0.5 (Hollander & Wolfe 1999, 3.1;
/// Pratt 1959). n = 0: p = 1.
SignedRank signedRank(const Numbers& differences, Zeros rule = Zeros::Pratt);

/// Two-sided p of the sign test: zeros are left out (Conover 1999, 3.4). Nothing left: 1.
double signTestP(const Numbers& differences);

/// The typical difference: median of the means of all pairs of differences, each with itself too
/// (Hodges & Lehmann 1963; Hollander & Wolfe 1999, 3.2). n = 0: NaN.
double pairedShift(const Numbers& differences);
/// Its interval (idem 3.3), from the exact distribution of the signed-rank sum for n <= 50, else
/// from the normal one. Zeros and ties stay in. Undefined where n is too small (95 %: n < 6).
Interval pairedShiftInterval(const Numbers& differences, double level = 0.95);

}  // namespace statistics
