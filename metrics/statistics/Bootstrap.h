#pragma once

#include <cstdint>
#include <functional>

#include "metrics/statistics/Summary.h"

namespace statistics {

using Statistic = std::function<double(const Numbers&)>;

struct BootstrapOptions {
  double level = 0.95;
  int resamples = 2000;
  std::uint64_t seed = 1;  // the same seed gives the same interval
};

/// Bias-corrected and accelerated bootstrap interval (Efron 1987, Better bootstrap confidence
/// intervals, JASA 82, equations 2.3 and 6.6; Efron & Tibshirani 1993, 14.3): z0 from the share of
/// resamples below the estimate (half of those equal to it, up to rounding), acceleration from the
/// jackknife, ends as quantiles of type 7. Draws are base::Draw::Bootstrap of (seed, resample,
/// place). n < 2: undefined. All equal, or all resamples equal: no width, at the estimate.
Interval bootstrapInterval(const Numbers& values, const Statistic& statistic,
                           const BootstrapOptions& options = {});

/// The same of the mean, faster.
Interval bootstrapMeanInterval(const Numbers& values, const BootstrapOptions& options = {});

/// The same of a statistic of rows: it is told which of the `n` rows are in a resample.
using RowStatistic = std::function<double(const std::vector<std::size_t>& rows)>;
Interval bootstrapRowsInterval(std::size_t n, const RowStatistic& statistic,
                               const BootstrapOptions& options = {});

}  // namespace statistics
