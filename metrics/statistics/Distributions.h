#pragma once

/// Distributions that tests and intervals are made of, by Boost.Math; the one file that sees it.
/// Pure functions, any thread; NaN in, NaN out.
namespace statistics {

double normalDensity(double z);
double normalCdf(double z);
double normalTail(double z);                       // P(Z > z), exact also far out
double normalQuantile(double p);                   // p in [0, 1]; -inf and inf at its ends
double studentQuantile(double p, double freedom);  // freedom > 0
double chiSquaredTail(double x, double freedom);   // P(X > x); x < 0 counts as 0
/// P(F > f) of Fisher's F with (freedom1, freedom2); f = inf: 0.
double fisherTail(double f, double freedom1, double freedom2);
/// P(X <= successes) of n trials with chance p; below 0: 0.
double binomialCdf(double successes, double n, double p);

/// P(Q > q) of the studentized range of `groups` means with `freedom` degrees of freedom of the
/// estimate of their spread (infinite: it is known). Integrated numerically, error below 1e-7:
/// P(Q <= q | inf) = k ∫ φ(z) [Φ(z) - Φ(z - q)]^(k-1) dz, averaged over the spread's chi
/// distribution for finite freedom (Copenhaver & Holland 1988, equations 1 and 2). q <= 0: 1.
/// groups >= 2.
double studentizedRangeTail(double q, int groups, double freedom);
/// The q with that tail: tables of the studentized range have it. tail in (0, 1).
double studentizedRangeQuantile(double tail, int groups, double freedom);

}  // namespace statistics
