#pragma once

#include <cmath>
#include <limits>
#include <vector>

/// Statistics of one sample. Callers must exclude NaN, in this and all other headers of the folder;
/// results are NaN if the sample is too small. Pure functions, thread-safe.
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

}  // namespace statistics
