#pragma once

/// Distributions for tests and intervals, by Boost.Math, which only this file includes. Pure
/// functions, thread-safe; NaN in, NaN out.
namespace statistics {

double normalDensity(double z);
double normalCdf(double z);
double normalTail(double z);                       // P(Z > z), accurate in the far tail
double normalQuantile(double p);                   // p in [0, 1]; -inf and inf at the ends
double studentQuantile(double p, double freedom);  // freedom > 0
double chiSquaredTail(double x, double freedom);   // P(X > x); x < 0 is treated as 0
/// P(F > f) for Fisher's F with (freedom1, freedom2); f = inf: 0.
double fisherTail(double f, double freedom1, double freedom2);
/// P(X <= successes) for n trials with probability p; negative: 0.
double binomialCdf(double successes, double n, double p);

/// P(Q > q) for the studentized range of `groups` means with `freedom` degrees of freedom of the
/// variance estimate (infinite: known variance). Integrated numerically, error below 1e-7: P(Q <= q
/// | inf) = k ∫ φ(z) [Φ(z) - Φ(z - q)]^(k-1) dz, averaged over the chi distribution of the standard
/// deviation for finite freedom (Copenhaver & Holland 1988, equations 1 and 2). q <= 0: 1. groups
/// >= 2.
double studentizedRangeTail(double q, int groups, double freedom);
/// The quantile q for an upper tail probability, as in tables of the studentized range. tail in (0,
/// 1).
double studentizedRangeQuantile(double tail, int groups, double freedom);

}  // namespace statistics
