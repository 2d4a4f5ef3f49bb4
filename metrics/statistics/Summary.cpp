#include "metrics/statistics/Summary.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <utility>

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

void drawResample(std::size_t n, const BootstrapOptions& options, int resample,
                  std::vector<std::size_t>& rows) {
  const base::AgentRng rng(options.seed, 0, static_cast<std::uint64_t>(resample));
  rows.resize(n);
  for (std::size_t k = 0; k < n; ++k) {  // 32 bits times n: the bias is below n / 2^32
    const std::uint64_t bits =
        rng.bits(base::DrawPurpose::Bootstrap, static_cast<std::uint32_t>(k));
    rows[k] = static_cast<std::size_t>((bits * n) >> 32U);
  }
}

namespace {

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
  Numbers resampled(static_cast<std::size_t>(options.resamples));
  std::vector<std::size_t> rows;
  for (int k = 0; k < options.resamples; ++k) {
    drawResample(n, options, k, rows);
    double sum = 0.0;
    for (const std::size_t row : rows) {
      sum += values[row] - estimate;
    }
    resampled[static_cast<std::size_t>(k)] = estimate + sum / count;
  }
  return intervalOf(estimate, std::move(resampled), jackknife, options.level);
}

namespace {

namespace bm = boost::math;
// Invalid arguments give NaN instead of exceptions.
using Policy = bm::policies::policy<bm::policies::domain_error<bm::policies::ignore_error>,
                                    bm::policies::pole_error<bm::policies::ignore_error>,
                                    bm::policies::overflow_error<bm::policies::ignore_error>,
                                    bm::policies::evaluation_error<bm::policies::ignore_error>>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFar = 8.5;  // the normal density beyond is below 1e-16

/// Integral over [low, high] by 15-point Gauss quadrature on `pieces` equal intervals.
template <class Function>
double integrate(Function function, double low, double high, int pieces) {
  const double width = (high - low) / pieces;
  double sum = 0.0;
  for (int k = 0; k < pieces; ++k) {
    const double from = low + k * width;
    sum += bm::quadrature::gauss<double, 15>::integrate(function, from, from + width);
  }
  return sum;
}

}  // namespace

double normalDensity(double z) {
  return std::exp(-0.5 * z * z) * 0.39894228040143267794;
}

double normalCdf(double z) {
  return 0.5 * std::erfc(-z * 0.70710678118654752440);
}

double normalTail(double z) {
  return 0.5 * std::erfc(z * 0.70710678118654752440);
}

double normalQuantile(double p) {
  if (p == 0.0 || p == 1.0) {
    return std::copysign(kInfinity, p - 0.5);
  }
  if (!(p > 0.0 && p < 1.0)) {
    return kUndefined;
  }
  return bm::quantile(bm::normal_distribution<double, Policy>(), p);
}

double studentQuantile(double p, double freedom) {
  return bm::quantile(bm::students_t_distribution<double, Policy>(freedom), p);
}

double chiSquaredTail(double x, double freedom) {
  const bm::chi_squared_distribution<double, Policy> distribution(freedom);
  return std::isnan(x) ? kUndefined : bm::cdf(bm::complement(distribution, std::max(0.0, x)));
}

double fisherTail(double f, double freedom1, double freedom2) {
  if (std::isinf(f)) {
    return f > 0.0 ? 0.0 : 1.0;
  }
  const bm::fisher_f_distribution<double, Policy> distribution(freedom1, freedom2);
  return std::isnan(f) ? kUndefined : bm::cdf(bm::complement(distribution, std::max(0.0, f)));
}

double binomialCdf(double successes, double n, double p) {
  if (successes < 0.0 || successes >= n) {
    return successes < 0.0 ? 0.0 : 1.0;
  }
  return bm::cdf(bm::binomial_distribution<double, Policy>(n, p), std::floor(successes));
}

double rangeTail(double q, int groups) {
  if (!(q > 0.0)) {
    return std::isnan(q) ? kUndefined : 1.0;
  }
  const auto term = [q, groups](double z) {
    return normalDensity(z) * std::pow(normalCdf(z) - normalCdf(z - q), groups - 1);
  };
  const double cdf = groups * integrate(term, -kFar, kFar + std::min(q, kFar), 8);
  return std::max(0.0, 1.0 - std::min(1.0, cdf));
}

double rangeQuantile(double tail, int groups) {
  double low = 0.0;
  double high = 4.0;
  while (rangeTail(high, groups) > tail && high < 1e6) {
    high *= 2.0;
  }
  constexpr int kHalvings = 36;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (rangeTail(middle, groups) > tail ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace statistics
