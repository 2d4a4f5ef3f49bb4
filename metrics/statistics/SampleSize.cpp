#include "metrics/statistics/SampleSize.h"

#include <algorithm>
#include <utility>

#include "metrics/statistics/Distributions.h"

namespace statistics {

namespace {

constexpr double kFewestPairs = 2.0;

/// z of the two-sided level and of the power.
std::pair<double, double> quantilesOf(const Power& power) {
  return {normalQuantile(1.0 - power.level / 2.0), normalQuantile(power.power)};
}

}  // namespace

double pairsForMean(double difference, double standardDeviation, const Power& power) {
  if (!(difference != 0.0) || std::isnan(difference) || std::isnan(standardDeviation)) {
    return kUndefined;
  }
  if (standardDeviation == 0.0) {
    return kFewestPairs;
  }
  const auto [z, zPower] = quantilesOf(power);
  const double ratio = standardDeviation / difference;
  const double pairs = (z + zPower) * (z + zPower) * ratio * ratio + z * z / 2.0;
  return std::max(kFewestPairs, std::ceil(pairs));
}

double pairsForSignedRank(double chancePositive, const Power& power) {
  if (std::isnan(chancePositive) || chancePositive == 0.5) {
    return kUndefined;
  }
  const auto [z, zPower] = quantilesOf(power);
  const double distance = chancePositive - 0.5;
  return std::ceil((z + zPower) * (z + zPower) / (3.0 * distance * distance));
}

double chanceOfPositiveSum(Numbers differences) {
  if (differences.size() < 2) {
    return kUndefined;
  }
  std::sort(differences.begin(), differences.end());
  const auto n = static_cast<double>(differences.size());
  double positive = 0.0;
  for (auto each = differences.begin(); each != differences.end(); ++each) {
    const auto [from, to] = std::equal_range(each + 1, differences.end(), -*each);
    positive += 0.5 * static_cast<double>(to - from) + static_cast<double>(differences.end() - to);
  }
  return positive / (n * (n - 1.0) / 2.0);
}

}  // namespace statistics
