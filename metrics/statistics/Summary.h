#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

/// Statistics of one sample, and of success rates. Callers must exclude NaN, in this and all other
/// headers of the folder; results are NaN if the sample is too small. Pure functions, thread-safe.
namespace statistics {

using Numbers = std::vector<double>;
constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// A closed interval; NaN: undefined.
struct Interval {
  double low = kUndefined, high = kUndefined;
  bool isDefined() const { return !std::isnan(low) && !std::isnan(high); }
};

/// Arithmetic mean. n = 0: NaN. All values equal: exactly that value.
double mean(const Numbers& values);
/// Sample standard deviation, divisor n - 1. n < 2: NaN; all equal: 0.
double standardDeviation(const Numbers& values);
/// Median; for an even count the mean of the two middle values. n = 0: NaN.
double median(Numbers values);
/// Quantile of type 7 (Hyndman & Fan 1996; the default of R and numpy): linear between the order
/// statistics, x[(n - 1) p]. n = 0: NaN; n = 1: that value. p in [0, 1].
double quantile(Numbers values, double p);
/// Several quantiles with one sort.
Numbers quantiles(Numbers values, const Numbers& ps);

/// Student's interval for the mean: mean ± t(n - 1) sd / √n. n < 2: undefined; all equal: zero
/// width.
Interval meanInterval(const Numbers& values, double level = 0.95);
/// Distribution-free interval for the median between two order statistics, by the sign test
/// (Conover 1999, 3.2; Hollander & Wolfe 1999, 3.6). Its coverage is at least `level`; ties
/// increase it. Undefined if n is too small (95 %: n < 6).
Interval medianInterval(Numbers values, double level = 0.95);

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

struct BootstrapOptions {
  double level = 0.95;
  int resamples = 2000;
  std::uint64_t seed = 1;  // equal seeds give equal intervals
};

/// Draws the rows of one bootstrap resample of n rows, with replacement: a function of the seed,
/// the resample and the position only. n >= 1.
void drawResample(std::size_t n, const BootstrapOptions& options, int resample,
                  std::vector<std::size_t>& rows);

/// Bias-corrected and accelerated bootstrap interval (Efron 1987, Better bootstrap confidence
/// intervals, JASA 82, equations 2.3 and 6.6; Efron & Tibshirani 1993, 14.3) of the mean: z0 from
/// the share of resamples below the estimate (half of those equal to it, up to rounding),
/// acceleration from the jackknife, ends as quantiles of type 7. Draws are
/// base::DrawPurpose::Bootstrap of (seed, resample, index). n < 2: undefined. All values or all
/// resamples equal: zero width at the estimate.
Interval bootstrapMeanInterval(const Numbers& values, const BootstrapOptions& options = {});

// Distributions for tests and intervals. NaN in, NaN out.

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
/// infinite degrees of freedom. Integrated numerically, error below 1e-7: P(Q <= q) = k ∫ φ(z)
/// [Φ(z) - Φ(z - q)]^(k-1) dz (Copenhaver & Holland 1988, equation 1). q <= 0: 1. groups >= 2.
double rangeTail(double q, int groups);
/// The quantile q for an upper tail probability in (0, 1), as in tables.
double rangeQuantile(double tail, int groups);

}  // namespace statistics
