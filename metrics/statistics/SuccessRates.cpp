#include "metrics/statistics/SuccessRates.h"

#include <algorithm>

#include "metrics/statistics/Distributions.h"

namespace statistics {

namespace {

/// φ coefficient of the outcomes with a continuity-corrected numerator; 0 if a margin is empty.
double correlationOf(const PairedOutcomes& outcomes) {
  const double both = outcomes.both, first = outcomes.onlyFirst;
  const double second = outcomes.onlySecond, neither = outcomes.neither;
  const double margins = (both + first) * (second + neither) * (both + second) * (first + neither);
  const double product = both * neither - first * second;
  const double corrected =
      product > 0.0 ? std::max(0.0, product - outcomes.count() / 2.0) : product;
  return margins > 0.0 ? corrected / std::sqrt(margins) : 0.0;
}

/// Length of the third side of a triangle.
double combined(double one, double other, double correlation) {
  return std::sqrt(std::max(0.0, one * one - 2.0 * correlation * one * other + other * other));
}

}  // namespace

Interval pairedRateInterval(const PairedOutcomes& outcomes, double level) {
  const int n = outcomes.count();
  if (n <= 0) {
    return {};
  }
  const int firsts = outcomes.both + outcomes.onlyFirst;
  const int seconds = outcomes.both + outcomes.onlySecond;
  const double first = static_cast<double>(firsts) / n;
  const double second = static_cast<double>(seconds) / n;
  const Interval ofFirst = wilsonInterval(firsts, n, level);
  const Interval ofSecond = wilsonInterval(seconds, n, level);
  const double correlation = correlationOf(outcomes);
  const double difference = static_cast<double>(firsts - seconds) / n;
  return {difference - combined(first - ofFirst.low, ofSecond.high - second, correlation),
          difference + combined(ofFirst.high - first, second - ofSecond.low, correlation)};
}

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
