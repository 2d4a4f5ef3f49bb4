#pragma once

#include "metrics/statistics/Summary.h"

/// Effect sizes of two independent samples.
namespace statistics {

/// Cliff's delta (Cliff 1993): the share of pairs in which the first value is larger minus the
/// share in which it is smaller, in [-1, 1]; ties count as neither. NaN for an empty sample.
double cliffsDelta(const Numbers& first, const Numbers& second);
/// "negligible", "small", "medium", "large" at 0.147, 0.33, 0.474 (Romano et al. 2006).
const char* magnitudeOfDelta(double delta);

/// Median of all differences first - second (Hodges & Lehmann 1963; Hollander & Wolfe 1999, 4.2).
/// NaN for an empty sample.
double shift(const Numbers& first, const Numbers& second);
/// Confidence interval of shift() (Moses; Hollander & Wolfe 1999, 4.3), from the exact distribution
/// of the rank sum for n + m <= 50, otherwise from the normal approximation. Undefined if the
/// samples are too small for the level.
Interval shiftInterval(const Numbers& first, const Numbers& second, double level = 0.95);

}  // namespace statistics
