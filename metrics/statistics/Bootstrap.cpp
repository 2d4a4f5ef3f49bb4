#include "metrics/statistics/Bootstrap.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "metrics/statistics/Distributions.h"
#include "sim2d/base/Rng.h"

namespace statistics {

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

Interval bootstrapRowsInterval(std::size_t n, const RowStatistic& statistic,
                               const BootstrapOptions& options) {
  if (n < 2 || options.resamples < 2) {
    return {};
  }
  Rows rows(n);
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  const double estimate = statistic(rows);
  Numbers jackknife(n);
  Rows others(rows.begin() + 1, rows.end());
  for (std::size_t left = 0; left < n; ++left) {
    jackknife[left] = statistic(others);
    if (left + 1 < n) {
      others[left] = left;  // replaces the next left-out row
    }
  }
  Numbers resampled(static_cast<std::size_t>(options.resamples));
  for (int k = 0; k < options.resamples; ++k) {
    draw(n, options, k, rows);
    resampled[static_cast<std::size_t>(k)] = statistic(rows);
  }
  return intervalOf(estimate, std::move(resampled), jackknife, options.level);
}

Interval bootstrapInterval(const Numbers& values, const Statistic& statistic,
                           const BootstrapOptions& options) {
  Numbers chosen;
  const auto ofRows = [&](const Rows& rows) {
    chosen.clear();
    chosen.reserve(rows.size());
    for (const std::size_t row : rows) {
      chosen.push_back(values[row]);
    }
    return statistic(chosen);
  };
  return bootstrapRowsInterval(values.size(), ofRows, options);
}

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
