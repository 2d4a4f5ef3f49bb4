#include "metrics/statistics/Ranks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace statistics {

namespace {

/// Maps doubles to integers in the same order; adjacent doubles give adjacent integers.
std::int64_t toOrderedBits(double value) {
  std::int64_t bits = 0;
  const double positiveZero = value == 0.0 ? 0.0 : value;
  std::memcpy(&bits, &positiveZero, sizeof bits);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}

double valueAt(std::int64_t order) {
  const std::int64_t bits = order < 0 ? std::numeric_limits<std::int64_t>::min() - order : order;
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

}  // namespace

Numbers midranks(const Numbers& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&values](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  Numbers ranks(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first;
    while (end < order.size() && values[order[end]] == values[order[first]]) {
      ++end;
    }
    const double rank = 0.5 * (static_cast<double>(first + 1) + static_cast<double>(end));
    for (; first < end; ++first) {
      ranks[order[first]] = rank;
    }
  }
  return ranks;
}

double signedRankSumCdf(const Numbers& ranks, double t) {
  constexpr double kHalves = 2.0;  // sums of half ranks
  Numbers chances(static_cast<std::size_t>(kHalves * t) + 1, 0.0);
  chances[0] = 1.0;
  for (const double each : ranks) {
    const auto rank = static_cast<std::size_t>(kHalves * each);
    for (std::size_t sum = chances.size(); sum-- > 0;) {
      chances[sum] = 0.5 * (chances[sum] + (sum >= rank ? chances[sum - rank] : 0.0));
    }
  }
  return std::accumulate(chances.begin(), chances.end(), 0.0);
}

Numbers rankSumCdf(int n, int m) {
  // Coefficients of the Gaussian binomial: multiply by (1 - x^(m+k)), divide by (1 - x^k).
  const auto few = static_cast<std::size_t>(std::min(n, m));
  const auto many = static_cast<std::size_t>(std::max(n, m));
  Numbers counts(few * many + 1, 0.0);
  counts[0] = 1.0;
  for (std::size_t k = 1; k <= few; ++k) {
    for (std::size_t u = counts.size(); u-- > many + k;) {
      counts[u] -= counts[u - many - k];
    }
    for (std::size_t u = k; u < counts.size(); ++u) {
      counts[u] += counts[u - k];
    }
  }
  const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
  for (double& count : counts) {
    count /= all;
  }
  std::partial_sum(counts.begin(), counts.end(), counts.begin());
  return counts;
}

double pairMeansUpTo(const Numbers& sorted, double x) {
  double count = 0.0;
  std::size_t end = sorted.size();  // partners of the i-th have smaller indices
  for (std::size_t i = 0; i < end; ++i) {
    while (end > i && 0.5 * (sorted[i] + sorted[end - 1]) > x) {
      --end;
    }
    count += static_cast<double>(end - i);
  }
  return count;
}

double orderStatistic(const std::function<double(double)>& countUpTo, double k, double low,
                      double high) {
  std::int64_t from = toOrderedBits(low);
  std::int64_t to = toOrderedBits(high);
  while (from < to) {
    const std::int64_t middle =
        (from & to) + ((from ^ to) >> 1);  // their mean, rounded down, without overflow
    if (countUpTo(valueAt(middle)) >= k) {
      to = middle;
    } else {
      from = middle + 1;
    }
  }
  return valueAt(from);
}

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

namespace {

/// Probability that all blocks order their values like the first: for each, one in k! / (t! of each
/// tie).
double chanceOfAgreement(Numbers block, int blocks) {
  std::sort(block.begin(), block.end());
  double orders = 1.0;
  std::size_t equal = 0;
  for (std::size_t k = 0; k < block.size(); ++k) {
    equal = k > 0 && block[k] == block[k - 1] ? equal + 1 : 1;
    orders *= static_cast<double>(k + 1) / static_cast<double>(equal);
  }
  return std::pow(orders, 1.0 - blocks);
}

}  // namespace

Numbers holm(const Numbers& ps) {
  std::vector<std::size_t> order;
  order.reserve(ps.size());
  for (std::size_t k = 0; k < ps.size(); ++k) {
    if (!std::isnan(ps[k])) {
      order.push_back(k);
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [&ps](std::size_t a, std::size_t b) { return ps[a] < ps[b]; });
  Numbers adjusted(ps.size(), kUndefined);
  double least = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double factor = static_cast<double>(order.size() - k);
    least = std::max(least, std::min(1.0, factor * ps[order[k]]));
    adjusted[order[k]] = least;
  }
  return adjusted;
}

Friedman friedman(const std::vector<Numbers>& blocks) {
  Friedman result;
  result.blocks = static_cast<int>(blocks.size());
  result.options = blocks.empty() ? 0 : static_cast<int>(blocks.front().size());
  const double b = result.blocks;
  const double k = result.options;
  Numbers sums(static_cast<std::size_t>(result.options), 0.0);
  double squares = 0.0;
  for (const Numbers& block : blocks) {
    const Numbers ranks = midranks(block);
    for (std::size_t option = 0; option < sums.size(); ++option) {
      sums[option] += ranks[option];
      squares += ranks[option] * ranks[option];
    }
  }
  double spread = 0.0;
  for (const double sum : sums) {
    const double distance = sum - b * (k + 1.0) / 2.0;
    spread += distance * distance;
    result.meanRanks.push_back(sum / b);
  }
  const double within = squares - b * k * (k + 1.0) * (k + 1.0) / 4.0;
  if (result.blocks < 2 || result.options < 2 || within <= 0.0) {
    return result;
  }
  result.chiSquared = (k - 1.0) * spread / within;
  result.p = chiSquaredTail(result.chiSquared, k - 1.0);
  const double rest = b * (k - 1.0) - result.chiSquared;
  result.f = rest > 1e-12 * b ? (b - 1.0) * result.chiSquared / rest
                              : std::numeric_limits<double>::infinity();
  result.fP = std::isinf(result.f) ? chanceOfAgreement(blocks.front(), result.blocks)
                                   : fisherTail(result.f, k - 1.0, (k - 1.0) * (b - 1.0));
  return result;
}

double nemenyiDifference(int options, int blocks, double level) {
  constexpr double kRootOfTwo = 1.41421356237309504880;
  const double q = rangeQuantile(1.0 - level, options);
  return q / kRootOfTwo * std::sqrt(options * (options + 1.0) / (6.0 * blocks));
}

namespace {

/// Normalises the direction: smaller is better.
double costOf(double value, Sense sense) {
  return sense == Sense::Lower ? value : -value;
}

/// Positions between the worst (0) and the best (1) value.
Numbers normalisedScores(const Criterion& criterion) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const double value : criterion.values) {
    if (!std::isnan(value)) {
      least = std::min(least, costOf(value, criterion.sense));
      most = std::max(most, costOf(value, criterion.sense));
    }
  }
  Numbers places;
  places.reserve(criterion.values.size());
  for (const double value : criterion.values) {
    const double cost = costOf(value, criterion.sense);
    places.push_back(most > least ? (most - cost) / (most - least)
                                  : (std::isnan(value) ? kUndefined : 1.0));
  }
  return places;
}

}  // namespace

std::vector<bool> paretoFront(const Numbers& x, Sense xSense, const Numbers& y, Sense ySense) {
  const auto isDefined = [&](std::size_t k) { return !std::isnan(x[k]) && !std::isnan(y[k]); };
  const auto beats = [&](std::size_t a, std::size_t b) {
    const double dx = costOf(x[a], xSense) - costOf(x[b], xSense);
    const double dy = costOf(y[a], ySense) - costOf(y[b], ySense);
    return dx <= 0.0 && dy <= 0.0 && (dx < 0.0 || dy < 0.0);
  };
  std::vector<bool> onFront(x.size(), false);
  for (std::size_t k = 0; k < x.size(); ++k) {
    onFront[k] = isDefined(k);
    for (std::size_t other = 0; onFront[k] && other < x.size(); ++other) {
      onFront[k] = !isDefined(other) || !beats(other, k);
    }
  }
  return onFront;
}

Numbers composite(const std::vector<Criterion>& criteria) {
  const std::size_t options = criteria.empty() ? 0 : criteria.front().values.size();
  Numbers sums(options, 0.0);
  double weights = 0.0;
  for (const Criterion& criterion : criteria) {
    if (criterion.weight == 0.0) {
      continue;
    }
    const Numbers places = normalisedScores(criterion);
    weights += criterion.weight;
    for (std::size_t option = 0; option < options; ++option) {
      sums[option] += criterion.weight * places[option];
    }
  }
  for (double& sum : sums) {
    sum = weights > 0.0 ? sum / weights : kUndefined;
  }
  return sums;
}

}  // namespace statistics
