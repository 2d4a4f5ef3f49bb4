#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/SeriesMetric.h"

namespace metrics {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

MetricValue nobody(const MetricParameters& parameters) {
  return undefinedValue(parameters.profile == Profile::Hunav2 ? "ValueError: nobody in the record"
                                                              : "nobody in the record");
}

MetricValue averageDistance(const std::vector<double>& closest, const Recording& recording,
                            const MetricParameters& parameters) {
  const bool original = parameters.profile == Profile::Hunav2;
  std::vector<double> series;
  double sum = 0.0;
  std::size_t met = 0;
  for (const double distance : closest) {
    const bool isMet = !std::isnan(distance);
    sum += isMet ? distance : 0.0;
    met += isMet ? 1 : 0;
    if (isMet || !original) {
      series.push_back(distance);
    }
  }
  const std::size_t divisor = original ? recording.size() : met;
  MetricValue value = divisor == 0 ? undefinedValue("nobody in the record")
                                   : numberValue(sum / static_cast<double>(divisor));
  return withSeries(std::move(value), std::move(series));
}

/// Smallest or largest of the terms that are defined.
std::optional<double> extremeOf(const std::vector<double>& terms, bool largest) {
  std::optional<double> extreme;
  for (const double term : terms) {
    const bool better = !extreme || (largest ? term > *extreme : term < *extreme);
    if (!std::isnan(term) && better) {
      extreme = term;
    }
  }
  return extreme;
}

MetricValue minimumDistance(const std::vector<double>& closest, const Recording& /*recording*/,
                            const MetricParameters& parameters) {
  const std::optional<double> smallest = extremeOf(closest, false);
  return smallest ? numberValue(*smallest) : nobody(parameters);
}

double farthestGap(const Sample& sample, const MetricParameters& /*parameters*/) {
  double farthest = kNaN;
  for (const Person& person : sample.people) {
    const double value = gap(sample.robot, person);
    farthest = value <= farthest ? farthest : value;
  }
  return farthest;
}

MetricValue maximumDistance(const std::vector<double>& farthest, const Recording& /*recording*/,
                            const MetricParameters& parameters) {
  const std::optional<double> largest = extremeOf(farthest, true);
  if (!largest) {
    return nobody(parameters);
  }
  return numberValue(parameters.profile == Profile::Hunav2 ? *largest : std::max(*largest, 0.0));
}

}  // namespace

void addPeopleDistances(MetricRegistry& to) {
  const Needs needs{true, true};
  const char source[] = "Perez-Higueras, Caballero, Merino, IJSR 2018";
  addSeriesMetric(to,
                  {"avg_distance_to_closest_person", "Mean distance to the closest person", "m",
                   Category::Social, Better::Higher, needs,
                   "mean of c_i over the samples with people; c_i = min over a of max(gap(i,a), 0)",
                   source, "[0, inf)", Kind::Number, 4, ""},
                  closestGapTerm, averageDistance);
  addSeriesMetric(to,
                  {"minimum_distance_to_people", "Smallest distance to people", "m",
                   Category::Social, Better::Higher, needs, "min over i, a of max(gap(i,a), 0)",
                   source, "[0, inf)", Kind::Number, 5, ""},
                  closestGapTerm, minimumDistance);
  addSeriesMetric(to,
                  {"maximum_distance_to_people", "Largest distance to people", "m",
                   Category::Navigation, Better::Neutral, needs,
                   "max over i, a of max(gap(i,a), 0)", source, "[0, inf)", Kind::Number, 6, ""},
                  farthestGap, maximumDistance);
}

}  // namespace metrics
