#include "metrics/statistics/Distributions.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>

namespace statistics {

namespace {

namespace bm = boost::math;
// Invalid arguments give NaN instead of exceptions.
using Policy = bm::policies::policy<bm::policies::domain_error<bm::policies::ignore_error>,
                                    bm::policies::pole_error<bm::policies::ignore_error>,
                                    bm::policies::overflow_error<bm::policies::ignore_error>,
                                    bm::policies::evaluation_error<bm::policies::ignore_error>>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
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
    return kNan;
  }
  return bm::quantile(bm::normal_distribution<double, Policy>(), p);
}

double studentQuantile(double p, double freedom) {
  return bm::quantile(bm::students_t_distribution<double, Policy>(freedom), p);
}

double chiSquaredTail(double x, double freedom) {
  const bm::chi_squared_distribution<double, Policy> distribution(freedom);
  return std::isnan(x) ? kNan : bm::cdf(bm::complement(distribution, std::max(0.0, x)));
}

double fisherTail(double f, double freedom1, double freedom2) {
  if (std::isinf(f)) {
    return f > 0.0 ? 0.0 : 1.0;
  }
  const bm::fisher_f_distribution<double, Policy> distribution(freedom1, freedom2);
  return std::isnan(f) ? kNan : bm::cdf(bm::complement(distribution, std::max(0.0, f)));
}

double binomialCdf(double successes, double n, double p) {
  if (successes < 0.0 || successes >= n) {
    return successes < 0.0 ? 0.0 : 1.0;
  }
  return bm::cdf(bm::binomial_distribution<double, Policy>(n, p), std::floor(successes));
}

double rangeTail(double q, int groups) {
  if (!(q > 0.0)) {
    return std::isnan(q) ? kNan : 1.0;
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
