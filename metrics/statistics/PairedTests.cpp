#include "metrics/statistics/PairedTests.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "metrics/statistics/Ranks.h"

namespace statistics {

namespace {

constexpr std::size_t kMostExactlyStratified = 50;   // differences
constexpr std::size_t kMostRankedOfStrata = 10'000;  // with zeros, limit for an exact test
constexpr long long kMostUnits = 100'000;            // limit for integer weights

struct Weights {
  Numbers each;             // van Elteren's, per stratum
  bool areIntegers = true;  // otherwise the smallest is 1
};

Strata withoutEmpty(const Strata& strata) {
  Strata kept;
  std::copy_if(strata.begin(), strata.end(), std::back_inserter(kept),
               [](const Numbers& each) { return !each.empty(); });
  return kept;
}

std::size_t countOf(const Strata& strata) {
  return std::accumulate(strata.begin(), strata.end(), std::size_t{0},
                         [](std::size_t sum, const Numbers& each) { return sum + each.size(); });
}

/// Weights of strata of these sizes, as the smallest integers unless they are too large.
Weights weightsOf(const Strata& strata) {
  Weights weights;
  long long common = 1;
  std::size_t largest = 0;
  for (const Numbers& each : strata) {
    common = std::min(std::lcm(common, static_cast<long long>(each.size()) + 1), kMostUnits + 1);
    largest = std::max(largest, each.size());
    weights.areIntegers = weights.areIntegers && common <= kMostUnits;
  }
  long long shared = weights.areIntegers ? common : 1;
  for (const Numbers& each : strata) {
    const auto size = static_cast<long long>(each.size()) + 1;
    shared = std::gcd(shared, weights.areIntegers ? common / size : 1);
  }
  for (const Numbers& each : strata) {
    const auto size = static_cast<long long>(each.size()) + 1;
    const long long whole = weights.areIntegers ? common / size / shared : 0;  // exact division
    weights.each.push_back(weights.areIntegers
                               ? static_cast<double>(whole)
                               : static_cast<double>(largest + 1) / static_cast<double>(size));
  }
  return weights;
}

double smallest(const Weights& weights) {
  return *std::min_element(weights.each.begin(), weights.each.end());
}

/// Ranks of the non-zero differences, multiplied by the weight of their stratum.
struct WeightedRanks {
  Numbers ranks;
  double plus = 0.0;  // sum over positive differences
  int zeros = 0;
};

void addStratum(const Numbers& differences, double weight, WeightedRanks& to) {
  Numbers sizes;
  sizes.reserve(differences.size());
  std::transform(differences.begin(), differences.end(), std::back_inserter(sizes),
                 [](double difference) { return std::abs(difference); });
  const Numbers ranks = midranks(sizes);
  for (std::size_t k = 0; k < differences.size(); ++k) {
    if (differences[k] == 0.0) {
      ++to.zeros;
      continue;
    }
    to.ranks.push_back(weight * ranks[k]);
    to.plus += differences[k] > 0.0 ? to.ranks.back() : 0.0;
  }
}

double normalP(const WeightedRanks& all, double correction) {
  double sum = 0.0;
  double squares = 0.0;
  for (const double rank : all.ranks) {
    sum += rank;
    squares += rank * rank;
  }
  const double distance = std::max(0.0, std::abs(all.plus - 0.5 * sum) - correction);
  return std::min(1.0, 2.0 * normalTail(distance / (0.5 * std::sqrt(squares))));
}

double exactP(const WeightedRanks& all) {
  const double sum = std::accumulate(all.ranks.begin(), all.ranks.end(), 0.0);
  return std::min(1.0, 2.0 * signedRankSumCdf(all.ranks, std::min(all.plus, sum - all.plus)));
}

/// Weighted means of pairs of differences within the strata: total weight up to a value.
class PairMeans {
 public:
  PairMeans(const Strata& strata, Numbers weights) : strata_(strata), weights_(std::move(weights)) {
    for (Numbers& each : strata_) {
      std::sort(each.begin(), each.end());
      low_ = std::min(low_, each.front());
      high_ = std::max(high_, each.back());
    }
  }

  double all() const { return upTo(high_); }
  /// The smallest mean up to which the total weight is at least `weight`.
  double at(double weight) const {
    return orderStatistic([this](double x) { return upTo(x); }, weight, low_, high_);
  }

 private:
  double upTo(double x) const {
    double weight = 0.0;
    for (std::size_t k = 0; k < strata_.size(); ++k) {
      weight += weights_[k] * pairMeansUpTo(strata_[k], x);
    }
    return weight;
  }

  Strata strata_;  // sorted
  Numbers weights_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

/// The largest sum of weighted ranks without ties whose cumulative probability is at most `miss`;
/// negative: none.
double exactExclusion(const Strata& strata, const Weights& weights, double miss) {
  Numbers chances(1, 1.0);
  for (std::size_t k = 0; k < strata.size(); ++k) {
    for (std::size_t rank = 1; rank <= strata[k].size(); ++rank) {
      const std::size_t step = rank * static_cast<std::size_t>(weights.each[k]);
      chances.resize(chances.size() + step, 0.0);
      for (std::size_t sum = chances.size(); sum-- > 0;) {
        chances[sum] = 0.5 * (chances[sum] + (sum >= step ? chances[sum - step] : 0.0));
      }
    }
  }
  double chance = 0.0;
  std::size_t sum = 0;
  while (sum < chances.size() && chance + chances[sum] <= miss) {
    chance += chances[sum++];
  }
  return static_cast<double>(sum) - 1.0;
}

double excludedOnEachSide(const Strata& strata, const Weights& weights, double level) {
  const double miss = (1.0 - level) / 2.0;
  if (countOf(strata) <= kMostExactlyStratified && weights.areIntegers) {
    return exactExclusion(strata, weights, miss);
  }
  double expected = 0.0;
  double variance = 0.0;
  for (std::size_t k = 0; k < strata.size(); ++k) {
    const auto n = static_cast<double>(strata[k].size());
    const double weight = weights.each[k];
    expected += weight * n * (n + 1.0) / 4.0;
    variance += weight * weight * n * (n + 1.0) * (2.0 * n + 1.0) / 24.0;
  }
  const double place =
      expected + normalQuantile(miss) * std::sqrt(variance) - 0.5 * smallest(weights);
  return std::floor(place);
}

}  // namespace

StratifiedSignedRank stratifiedSignedRank(const Strata& differences) {
  const Strata strata = withoutEmpty(differences);
  StratifiedSignedRank result;
  result.strata = static_cast<int>(strata.size());
  if (strata.empty()) {
    return result;
  }
  const Weights weights = weightsOf(strata);
  WeightedRanks all;
  for (std::size_t k = 0; k < strata.size(); ++k) {
    addStratum(strata[k], weights.each[k], all);
  }
  result.n = static_cast<int>(all.ranks.size());
  result.zeros = all.zeros;
  result.isExact = all.ranks.size() <= kMostExactlyStratified &&
                   countOf(strata) <= kMostRankedOfStrata && weights.areIntegers;
  if (result.n > 0) {
    result.p = result.isExact ? exactP(all) : normalP(all, 0.5 * smallest(weights));
  }
  return result;
}

double stratifiedShift(const Strata& differences) {
  const Strata strata = withoutEmpty(differences);
  if (strata.empty()) {
    return kUndefined;
  }
  const PairMeans means(strata, weightsOf(strata).each);
  constexpr double kMore = 1e-12;  // relative; more than half
  const double half = 0.5 * means.all();
  const double below = means.at(half * (1.0 - kMore));
  const double above = means.at(half * (1.0 + kMore));
  return below + 0.5 * (above - below);
}

Interval stratifiedShiftInterval(const Strata& differences, double level) {
  const Strata strata = withoutEmpty(differences);
  if (strata.empty()) {
    return {};
  }
  const Weights weights = weightsOf(strata);
  const double outside = excludedOnEachSide(strata, weights, level);
  if (outside < 0.0) {
    return {};
  }
  const PairMeans means(strata, weights.each);
  constexpr double kWeightRounding = 1e-9;  // of weights that are not integers
  return {means.at(outside + (weights.areIntegers ? 1.0 : kWeightRounding)),
          means.at(means.all() - outside)};
}

Interval stratifiedMeanInterval(const Strata& differences, double level) {
  const Strata strata = withoutEmpty(differences);
  const auto total = static_cast<double>(countOf(strata));
  double estimate = 0.0, variance = 0.0, freedom = 0.0;
  for (const Numbers& each : strata) {
    const auto n = static_cast<double>(each.size());
    const double share = n / total, deviation = standardDeviation(each);
    const double part = share * share * deviation * deviation / n;
    estimate += share * mean(each);
    variance += part;
    freedom += part > 0.0 ? part * part / (n - 1.0) : 0.0;
  }
  if (strata.empty() || std::isnan(variance)) {
    return {};
  }
  if (!(variance > 0.0)) {
    return {estimate, estimate};
  }
  const double half =
      studentQuantile(0.5 + level / 2.0, variance * variance / freedom) * std::sqrt(variance);
  return {estimate - half, estimate + half};
}

Interval stratifiedRateInterval(const std::vector<PairedOutcomes>& strata, double level) {
  double pairs = 0.0;
  for (const PairedOutcomes& each : strata) {
    pairs += each.count();
  }
  double difference = 0.0;
  double below = 0.0;
  double above = 0.0;
  for (const PairedOutcomes& each : strata) {
    if (each.count() == 0) {
      continue;
    }
    const double share = each.count() / pairs;
    const double own = static_cast<double>(each.onlyFirst - each.onlySecond) / each.count();
    const Interval interval = pairedRateInterval(each, level);
    difference += share * own;
    below += std::pow(share * (own - interval.low), 2.0);
    above += std::pow(share * (interval.high - own), 2.0);
  }
  return pairs > 0.0 ? Interval{difference - std::sqrt(below), difference + std::sqrt(above)}
                     : Interval();
}

namespace {

/// Normal quantiles of the two-sided level and of the power.
std::pair<double, double> quantilesOf(const Power& power) {
  return {normalQuantile(1.0 - power.level / 2.0), normalQuantile(power.power)};
}

/// The fewest pairs with which an exact test of signs or signed ranks can reach the level:
/// 2 / 2^n < level.
double fewestPairs(const Power& power) {
  return std::floor(1.0 - std::log2(power.level)) + 1.0;
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
  return std::max(fewestPairs(power), std::ceil(sum * sum / (difference * difference)));
}

double detectableRateDifference(double discordant, double pairs, const Power& power) {
  if (!(pairs >= 1.0) || std::isnan(discordant)) {
    return kUndefined;
  }
  const auto isEnough = [&](double difference) {
    const double differing = std::max(discordant, difference);
    const double first = 0.5 * (differing + difference);
    return pairsForMcNemar(first, differing - first, power) <= pairs;
  };
  double out = 0.0;
  double within = 1.0;
  if (!isEnough(within)) {
    return kUndefined;
  }
  constexpr int kHalvings = 30;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (out + within);
    (isEnough(middle) ? within : out) = middle;
  }
  return within;
}

double detectableShift(double deviation, double pairs, const Power& power) {
  constexpr double kPi = 3.14159265358979323846;
  const auto [z, zPower] = quantilesOf(power);
  return pairs >= fewestPairs(power) && deviation > 0.0
             ? (z + zPower) * deviation * std::sqrt(kPi / (3.0 * pairs))
             : kUndefined;
}

double pairsForSignedRank(double chancePositive, const Power& power) {
  if (std::isnan(chancePositive) || chancePositive == 0.5) {
    return kUndefined;
  }
  const auto [z, zPower] = quantilesOf(power);
  const double distance = chancePositive - 0.5;
  const double spread = 4.0 * chancePositive * (1.0 - chancePositive);
  const double sum = z + zPower * std::sqrt(spread);
  return std::max(fewestPairs(power), std::ceil(sum * sum / (3.0 * distance * distance)));
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
