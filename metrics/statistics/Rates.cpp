#include "metrics/statistics/Rates.h"

#include <algorithm>

#include "metrics/statistics/Distributions.h"

namespace statistics {

Interval wilsonInterval(int successes, int n, double level) {
  if (n <= 0) {
    return {};
  }
  const double z = normalQuantile(0.5 + level / 2.0);
  const double trials = n;
  const double rate = successes / trials;
  const double centre = 2.0 * successes + z * z;
  const double half = z * std::sqrt(z * z + 4.0 * successes * (1.0 - rate));
  const double below = 2.0 * (trials + z * z);
  return {successes == 0 ? 0.0 : (centre - half) / below,
          successes == n ? 1.0 : (centre + half) / below};
}

double mcNemarP(int onlyFirst, int onlySecond) {
  const double fewer = std::min(onlyFirst, onlySecond);
  return std::min(1.0, 2.0 * binomialCdf(fewer, onlyFirst + onlySecond, 0.5));
}

}  // namespace statistics
