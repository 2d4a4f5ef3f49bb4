#include "metrics/statistics/SampleSize.h"

#include <algorithm>
#include <utility>

#include "metrics/statistics/Distributions.h"

namespace statistics {

namespace {

/// Normal quantiles of the two-sided level and of the power.
std::pair<double, double> quantilesOf(const Power& power) {
  return {normalQuantile(1.0 - power.level / 2.0), normalQuantile(power.power)};
}

}  // namespace

double pairsForMcNemar(double onlyFirst, double onlySecond, const Power& power) {
  const double difference = onlyFirst - onlySecond;
  const double discordant = onlyFirst + onlySecond;
  if (!(difference != 0.0) || std::isnan(difference)) {
    return kUndefined;
  }
  const auto [z, zPower] = quantilesOf(power);
  const double spread = std::max(0.0, discordant - difference * difference);
  const double sum = z * std::sqrt(discordant) + zPower * std::sqrt(spread);
  const double fewest = std::floor(1.0 - std::log2(power.level)) + 1.0;  // 2 / 2^n < level
  return std::max(fewest, std::ceil(sum * sum / (difference * difference)));
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
