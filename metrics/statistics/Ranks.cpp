#include "metrics/statistics/Ranks.h"

#include <algorithm>
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

/// Converts probabilities to cumulative probabilities.
void accumulate(Numbers& chances) {
  std::partial_sum(chances.begin(), chances.end(), chances.begin());
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

double tieSum(Numbers values) {
  std::sort(values.begin(), values.end());
  double sum = 0.0;
  for (auto first = values.begin(); first != values.end();) {
    const auto end = std::upper_bound(first, values.end(), *first);
    const auto t = static_cast<double>(end - first);
    sum += t * t * t - t;
    first = end;
  }
  return sum;
}

Numbers signedRankCdf(int n) {
  const auto count = static_cast<std::size_t>(n);
  Numbers chances(count * (count + 1) / 2 + 1, 0.0);
  chances[0] = 1.0;
  for (std::size_t rank = 1; rank <= count; ++rank) {  // its sign: plus or minus
    for (std::size_t sum = rank * (rank + 1) / 2 + 1; sum-- > 0;) {
      chances[sum] = 0.5 * (chances[sum] + (sum >= rank ? chances[sum - rank] : 0.0));
    }
  }
  accumulate(chances);
  return chances;
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
  accumulate(counts);
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

}  // namespace statistics
