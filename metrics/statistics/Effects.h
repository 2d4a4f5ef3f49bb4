#pragma once

#include "metrics/statistics/Summary.h"

/// How large a difference between two independent samples is.
namespace statistics {

/// Cliff's delta (Cliff 1993): share of pairs in which the first is larger minus share in which it
/// is smaller, in [-1, 1]; ties count for neither. An empty sample: NaN.
double cliffsDelta(const Numbers& first, const Numbers& second);
/// "negligible", "small", "medium", "large" at 0.147, 0.33, 0.474 (Romano et al. 2006).
const char* sizeOfDelta(double delta);

/// Median of all differences first - second (Hodges & Lehmann 1963; Hollander & Wolfe 1999, 4.2).
/// An empty sample: NaN.
double shift(const Numbers& first, const Numbers& second);
/// Its interval (Moses; idem 4.3), from the exact distribution of the rank sum for n + m <= 50,
/// else from the normal one. Undefined where the samples are too small for the level.
Interval shiftInterval(const Numbers& first, const Numbers& second, double level = 0.95);

}  // namespace statistics
