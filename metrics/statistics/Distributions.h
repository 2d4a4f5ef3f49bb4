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

/// P(Q > q) for the range of `groups` standard normal numbers, that is, the studentized range with
/// infinite freedom. Integrated numerically, error below 1e-7: P(Q <= q) = k ∫ φ(z) [Φ(z) -
/// Φ(z - q)]^(k-1) dz (Copenhaver & Holland 1988, equation 1). q <= 0: 1. groups >= 2.
double rangeTail(double q, int groups);
/// The quantile q for an upper tail probability in (0, 1), as in tables.
double rangeQuantile(double tail, int groups);

}  // namespace statistics
