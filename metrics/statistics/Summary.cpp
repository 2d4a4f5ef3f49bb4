#include "metrics/statistics/Summary.h"

#include <algorithm>
#include <utility>

#include "metrics/statistics/Distributions.h"

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

}  // namespace statistics
