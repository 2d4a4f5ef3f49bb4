#include "metrics/statistics/Summary.h"

#include <algorithm>
#include <utility>

#include "metrics/statistics/Distributions.h"
#include "sim2d/base/Rng.h"

namespace statistics {

namespace {

double quantileOfSorted(const Numbers& sorted, double p) {
  if (sorted.empty()) {
    return kUndefined;
  }
  const double place = static_cast<double>(sorted.size() - 1) * p;
  const auto below = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(below);
  if (share == 0.0) {
    return sorted[below];
  }
  return sorted[below] + share * (sorted[below + 1] - sorted[below]);
}

}  // namespace

double mean(const Numbers& values) {
  if (values.empty()) {
    return kUndefined;
  }
  const double first = values.front();  // sums the differences: exact for equal numbers
  double sum = 0.0;
  for (const double value : values) {
    sum += value - first;
  }
  return first + sum / static_cast<double>(values.size());
}

double standardDeviation(const Numbers& values) {
  if (values.size() < 2) {
    return kUndefined;
  }
  const double centre = mean(values);
  double sum = 0.0;
  for (const double value : values) {
    sum += (value - centre) * (value - centre);
  }
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

double median(Numbers values) {
  return quantile(std::move(values), 0.5);
}

double quantile(Numbers values, double p) {
  std::sort(values.begin(), values.end());
  return quantileOfSorted(values, p);
}

Numbers quantiles(Numbers values, const Numbers& ps) {
  std::sort(values.begin(), values.end());
  Numbers results;
  results.reserve(ps.size());
  for (const double p : ps) {
    results.push_back(quantileOfSorted(values, p));
  }
  return results;
}

Interval meanInterval(const Numbers& values, double level) {
  if (values.size() < 2) {
    return {};
  }
  const auto n = static_cast<double>(values.size());
  const double half =
      studentQuantile(0.5 + level / 2.0, n - 1.0) * standardDeviation(values) / std::sqrt(n);
  const double centre = mean(values);
  return {centre - half, centre + half};
}

Interval medianInterval(Numbers values, double level) {
  const auto n = static_cast<double>(values.size());
  const double miss = (1.0 - level) / 2.0;  // on each side
  std::size_t outside = 0;                  // order statistics excluded on each side
  while (binomialCdf(static_cast<double>(outside), n, 0.5) <= miss) {
    ++outside;
  }
  if (outside == 0) {
    return {};
  }
  std::sort(values.begin(), values.end());
  return {values[outside - 1], values[values.size() - outside]};
}

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

namespace {

using Rows = std::vector<std::size_t>;

/// Draws the rows of one resample.
void draw(std::size_t n, const BootstrapOptions& options, int resample, Rows& rows) {
  const base::AgentRng rng(options.seed, 0, static_cast<std::uint64_t>(resample));
  rows.resize(n);
  for (std::size_t k = 0; k < n; ++k) {  // 32 bits times n: the bias is below n / 2^32
    const std::uint64_t bits =
        rng.bits(base::DrawPurpose::Bootstrap, static_cast<std::uint32_t>(k));
    rows[k] = static_cast<std::size_t>((bits * n) >> 32U);
  }
}

/// Σ d³ / (6 (Σ d²)^1.5) of the jackknife values' distances below their mean; 0 if all are equal.
double accelerationOf(const Numbers& jackknife) {
  const double centre = mean(jackknife);
  double squares = 0.0;
  double cubes = 0.0;
  for (const double value : jackknife) {
    const double below = centre - value;
    squares += below * below;
    cubes += below * below * below;
  }
  return squares > 0.0 ? cubes / (6.0 * std::pow(squares, 1.5)) : 0.0;
}

/// Position in the sorted resamples of the end with normal quantile z.
double shiftedShare(double bias, double acceleration, double z) {
  const double shifted = bias + z;
  return normalCdf(bias + shifted / (1.0 - acceleration * shifted));
}

/// Tolerance for resamples that equal the estimate except for summation order.
constexpr double kRounding = 1e-12;  // relative to the largest number

Interval intervalOf(double estimate, Numbers resampled, const Numbers& jackknife, double level) {
  const auto [least, most] = std::minmax_element(resampled.begin(), resampled.end());
  const double rounding = kRounding * std::max(std::abs(*least), std::abs(*most));
  if (*most - *least <= rounding) {
    return {*least, *most};
  }
  double below = 0.0;
  for (const double value : resampled) {
    below += std::abs(value - estimate) <= rounding ? 0.5 : value < estimate ? 1.0 : 0.0;
  }
  const auto count = static_cast<double>(resampled.size());
  // Limits estimates beyond all resamples.
  const double share = std::clamp(below / count, 0.5 / count, 1.0 - 0.5 / count);
  const double bias = normalQuantile(share);
  const double acceleration = accelerationOf(jackknife);
  const double z = normalQuantile(0.5 + level / 2.0);
  const Numbers ends = quantiles(std::move(resampled), {shiftedShare(bias, acceleration, -z),
                                                        shiftedShare(bias, acceleration, z)});
  return {ends[0], ends[1]};
}

}  // namespace

Interval bootstrapMeanInterval(const Numbers& values, const BootstrapOptions& options) {
  const std::size_t n = values.size();
  if (n < 2 || options.resamples < 2) {
    return {};
  }
  const auto count = static_cast<double>(n);
  const double estimate = mean(values);
  Numbers jackknife(n);
  for (std::size_t k = 0; k < n; ++k) {
    jackknife[k] = estimate + (estimate - values[k]) / (count - 1.0);
  }
  Rows rows;
  Numbers resampled(static_cast<std::size_t>(options.resamples));
  for (int k = 0; k < options.resamples; ++k) {
    draw(n, options, k, rows);
    double sum = 0.0;
    for (const std::size_t row : rows) {
      sum += values[row] - estimate;
    }
    resampled[static_cast<std::size_t>(k)] = estimate + sum / count;
  }
  return intervalOf(estimate, std::move(resampled), jackknife, options.level);
}

}  // namespace statistics
