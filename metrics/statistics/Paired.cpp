#include "metrics/statistics/Paired.h"

#include <algorithm>

#include "metrics/statistics/Distributions.h"
#include "metrics/statistics/Ranks.h"

namespace statistics {

namespace {

constexpr std::size_t kLargestExact = 50;
constexpr int kMostRanked = 10'000;  // with zeros, of an exact test

/// By the normal distribution; `sizes` are the sizes of the differences that are not zero.
double normalP(const SignedRank& result, const Numbers& sizes, int rankedZeros) {
  const double all = result.n + rankedZeros;
  const double zeros = rankedZeros;
  const double expected = (all * (all + 1.0) - zeros * (zeros + 1.0)) / 4.0;
  const double variance = (all * (all + 1.0) * (2.0 * all + 1.0) -
                           zeros * (zeros + 1.0) * (2.0 * zeros + 1.0) - 0.5 * tieSum(sizes)) /
                          24.0;
  const double distance = std::max(0.0, std::abs(result.plus - expected) - 0.5);
  return variance > 0.0 ? std::min(1.0, 2.0 * normalTail(distance / std::sqrt(variance))) : 1.0;
}

double exactP(const SignedRank& result, const Numbers& ranks) {
  return std::min(1.0, 2.0 * signedSumAtMost(ranks, std::min(result.plus, result.minus)));
}

double pairMean(const Numbers& sorted, double k) {
  return orderStatistic([&sorted](double x) { return pairMeansUpTo(sorted, x); }, k, sorted.front(),
                        sorted.back());
}

/// How many of the means of pairs lie outside of the interval on either side; negative = n is too
/// small for one.
double leftOutOnEachSide(std::size_t n, double level) {
  const double miss = (1.0 - level) / 2.0;
  if (n <= kLargestExact) {
    const Numbers cdf = signedRankCdf(static_cast<int>(n));
    const auto first = std::find_if(cdf.begin(), cdf.end(), [miss](double p) { return p > miss; });
    return static_cast<double>(first - cdf.begin()) - 1.0;
  }
  const auto count = static_cast<double>(n);
  const double expected = count * (count + 1.0) / 4.0;
  const double deviation = std::sqrt(count * (count + 1.0) * (2.0 * count + 1.0) / 24.0);
  return std::floor(expected + normalQuantile(miss) * deviation - 0.5);
}

}  // namespace

SignedRank signedRank(const Numbers& differences, Zeros rule) {
  Numbers ranked;
  for (const double difference : differences) {
    if (rule == Zeros::Pratt || difference != 0.0) {
      ranked.push_back(std::abs(difference));
    }
  }
  const Numbers ranks = midranks(ranked);
  SignedRank result;
  Numbers sizes;
  Numbers counted;  // ranks of what is not zero
  std::size_t at = 0;
  for (const double difference : differences) {
    if (difference == 0.0) {
      ++result.zeros;
      at += rule == Zeros::Pratt ? 1 : 0;
      continue;
    }
    (difference > 0.0 ? result.plus : result.minus) += ranks[at];
    counted.push_back(ranks[at++]);
    sizes.push_back(std::abs(difference));
    ++result.n;
  }
  const int rankedZeros = rule == Zeros::Pratt ? result.zeros : 0;
  result.isExact = sizes.size() <= kLargestExact && result.n + rankedZeros <= kMostRanked;
  if (result.n > 0) {
    result.p = result.isExact ? exactP(result, counted) : normalP(result, sizes, rankedZeros);
  }
  return result;
}

double signTestP(const Numbers& differences) {
  const auto plus = std::count_if(differences.begin(), differences.end(),
                                  [](double difference) { return difference > 0.0; });
  const auto minus = std::count_if(differences.begin(), differences.end(),
                                   [](double difference) { return difference < 0.0; });
  const auto fewer = static_cast<double>(std::min(plus, minus));
  return std::min(1.0, 2.0 * binomialCdf(fewer, static_cast<double>(plus + minus), 0.5));
}

double pairedShift(const Numbers& differences) {
  if (differences.empty()) {
    return kUndefined;
  }
  Numbers sorted = differences;
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(sorted.size());
  const double count = n * (n + 1.0) / 2.0;
  const double below = pairMean(sorted, std::floor((count + 1.0) / 2.0));
  const double above = pairMean(sorted, std::ceil((count + 1.0) / 2.0));
  return below + 0.5 * (above - below);
}

Interval pairedShiftInterval(const Numbers& differences, double level) {
  const double outside = differences.empty() ? -1.0 : leftOutOnEachSide(differences.size(), level);
  if (outside < 0.0) {
    return {};
  }
  Numbers sorted = differences;
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(sorted.size());
  const double count = n * (n + 1.0) / 2.0;
  return {pairMean(sorted, outside + 1.0), pairMean(sorted, count - outside)};
}

}  // namespace statistics
