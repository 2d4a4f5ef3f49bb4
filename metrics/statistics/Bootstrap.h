#pragma once

#include <cstdint>
#include <functional>

#include "metrics/statistics/Summary.h"

namespace statistics {

using Statistic = std::function<double(const Numbers&)>;

struct BootstrapOptions {
  double level = 0.95;
  int resamples = 2000;
  std::uint64_t seed = 1;  // equal seeds give equal intervals
};

/// Bias-corrected and accelerated bootstrap interval (Efron 1987, Better bootstrap confidence
/// intervals, JASA 82, equations 2.3 and 6.6; Efron & Tibshirani 1993, 14.3): z0 from the share of
/// resamples below the estimate (half of those equal to it, up to rounding), acceleration from the
/// jackknife, ends as quantiles of type 7. Draws are base::DrawPurpose::Bootstrap of (seed,
/// resample, index). n < 2: undefined. All values or all resamples equal: zero width at the
/// estimate.
Interval bootstrapInterval(const Numbers& values, const Statistic& statistic,
                           const BootstrapOptions& options = {});

/// The interval of the mean, computed faster.
Interval bootstrapMeanInterval(const Numbers& values, const BootstrapOptions& options = {});

/// The interval of a statistic of rows, which receives the row indices of a resample of `n` rows.
using RowStatistic = std::function<double(const std::vector<std::size_t>& rows)>;
Interval bootstrapRowsInterval(std::size_t n, const RowStatistic& statistic,
                               const BootstrapOptions& options = {});

}  // namespace statistics
