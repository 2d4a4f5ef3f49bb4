#pragma once

#include <cmath>
#include <limits>
#include <vector>

/// Statistics of one sample. Everywhere here the caller leaves NaN out; what a sample is too small
/// for is NaN. Pure functions, any thread.
namespace statistics {

using Numbers = std::vector<double>;
constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// Both ends belong to it; NaN = undefined.
struct Interval {
  double low = kUndefined, high = kUndefined;
  bool isDefined() const { return !std::isnan(low) && !std::isnan(high); }
};

/// Arithmetic mean. n = 0: NaN. All equal: that number exactly.
double mean(const Numbers& values);
/// Standard deviation of a sample, divisor n - 1. n < 2: NaN; all equal: 0.
double standardDeviation(const Numbers& values);
/// The middle value, of an even number the mean of the middle two. n = 0: NaN.
double median(Numbers values);
/// Quantile of type 7 (Hyndman & Fan 1996; the usual one of R and numpy): linear between the order
/// statistics, x[(n - 1) p]. n = 0: NaN; n = 1: that number. p in [0, 1].
double quantile(Numbers values, double p);
/// Several quantiles at the price of one sort.
Numbers quantiles(Numbers values, const Numbers& ps);

/// Student's interval for the mean: mean ± t(n - 1) sd / √n. n < 2: undefined; all equal: no width.
Interval meanInterval(const Numbers& values, double level = 0.95);
/// Interval for the median between two order statistics, by the sign test (Conover 1999, 3.2;
/// Hollander & Wolfe 1999, 3.6): of any distribution, covers at least `level`. Undefined where n is
/// too small for the level (95 %: n < 6). Ties only make it cover more.
Interval medianInterval(Numbers values, double level = 0.95);

}  // namespace statistics
