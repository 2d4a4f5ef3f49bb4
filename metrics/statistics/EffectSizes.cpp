#include "metrics/statistics/EffectSizes.h"

#include <algorithm>

#include "metrics/statistics/Distributions.h"
#include "metrics/statistics/Ranks.h"

namespace statistics {

namespace {

constexpr std::size_t kMostExact = 50;

Numbers sortedOf(Numbers values) {
  std::sort(values.begin(), values.end());
  return values;
}

/// Number of differences first - second of sorted samples that are at most x.
double differencesUpTo(const Numbers& first, const Numbers& second, double x) {
  double count = 0.0;
  std::size_t from = 0;  // first index of `second` that is close enough
  for (const double value : first) {
    while (from < second.size() && value - second[from] > x) {
      ++from;
    }
    count += static_cast<double>(second.size() - from);
  }
  return count;
}

double differenceAt(const Numbers& first, const Numbers& second, double k) {
  return orderStatistic([&](double x) { return differencesUpTo(first, second, x); }, k,
                        first.front() - second.back(), first.back() - second.front());
}

/// Number of differences outside the interval on each side; negative: too few.
double excludedDifferences(std::size_t n, std::size_t m, double level) {
  const double miss = (1.0 - level) / 2.0;
  if (n + m <= kMostExact) {
    const Numbers cdf = rankSumCdf(static_cast<int>(n), static_cast<int>(m));
    const auto first = std::find_if(cdf.begin(), cdf.end(), [miss](double p) { return p > miss; });
    return static_cast<double>(first - cdf.begin()) - 1.0;
  }
  const double product = static_cast<double>(n) * static_cast<double>(m);
  const double deviation = std::sqrt(product * static_cast<double>(n + m + 1) / 12.0);
  return std::floor(product / 2.0 + normalQuantile(miss) * deviation - 0.5);
}

}  // namespace

double cliffsDelta(const Numbers& first, const Numbers& second) {
  if (first.empty() || second.empty()) {
    return kUndefined;
  }
  const Numbers others = sortedOf(second);
  double sum = 0.0;
  for (const double value : first) {
    const auto [from, to] = std::equal_range(others.begin(), others.end(), value);
    sum += static_cast<double>(from - others.begin()) - static_cast<double>(others.end() - to);
  }
  return sum / (static_cast<double>(first.size()) * static_cast<double>(second.size()));
}

const char* magnitudeOfDelta(double delta) {
  const double size = std::abs(delta);
  return size < 0.147 ? "negligible" : size < 0.33 ? "small" : size < 0.474 ? "medium" : "large";
}

double shift(const Numbers& first, const Numbers& second) {
  if (first.empty() || second.empty()) {
    return kUndefined;
  }
  const Numbers a = sortedOf(first);
  const Numbers b = sortedOf(second);
  const double count = static_cast<double>(a.size()) * static_cast<double>(b.size());
  const double below = differenceAt(a, b, std::floor((count + 1.0) / 2.0));
  const double above = differenceAt(a, b, std::ceil((count + 1.0) / 2.0));
  return below + 0.5 * (above - below);
}

Interval shiftInterval(const Numbers& first, const Numbers& second, double level) {
  const bool isEmpty = first.empty() || second.empty();
  const double outside = isEmpty ? -1.0 : excludedDifferences(first.size(), second.size(), level);
  if (outside < 0.0) {
    return {};
  }
  const Numbers a = sortedOf(first);
  const Numbers b = sortedOf(second);
  const double count = static_cast<double>(a.size()) * static_cast<double>(b.size());
  return {differenceAt(a, b, outside + 1.0), differenceAt(a, b, count - outside)};
}

}  // namespace statistics
