#include <algorithm>
#include <limits>

#include "metrics/MetricRegistry.h"

namespace metrics {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

MetricValue nobody(const MetricParameters& parameters) {
  return undefinedValue(parameters.profile == Profile::Hunav2 ? "ValueError: nobody in the record"
                                                              : "nobody in the record");
}

MetricValue averageDistance(const Recording& recording, const MetricParameters& parameters) {
  const bool original = parameters.profile == Profile::Hunav2;
  std::vector<double> series;
  double sum = 0.0;
  std::size_t met = 0;
  for (const Sample& sample : recording.samples) {
    const std::optional<double> closest = closestGap(sample);
    if (closest) {
      sum += *closest;
      ++met;
    }
    if (closest || !original) {
      series.push_back(closest.value_or(kNaN));
    }
  }
  const std::size_t divisor = original ? recording.size() : met;
  MetricValue value = divisor == 0 ? undefinedValue("nobody in the record")
                                   : numberValue(sum / static_cast<double>(divisor));
  return withSeries(std::move(value), std::move(series));
}

MetricValue minimumDistance(const Recording& recording, const MetricParameters& parameters) {
  std::optional<double> smallest;
  for (const Sample& sample : recording.samples) {
    const std::optional<double> closest = closestGap(sample);
    if (closest && (!smallest || *closest < *smallest)) {
      smallest = closest;
    }
  }
  return smallest ? numberValue(*smallest) : nobody(parameters);
}

MetricValue maximumDistance(const Recording& recording, const MetricParameters& parameters) {
  std::optional<double> largest;
  for (const Sample& sample : recording.samples) {
    for (const Person& person : sample.people) {
      const double value = gap(sample.robot, person);
      largest = largest ? std::max(*largest, value) : value;
    }
  }
  if (!largest) {
    return nobody(parameters);
  }
  return numberValue(parameters.profile == Profile::Hunav2 ? *largest : std::max(*largest, 0.0));
}

}  // namespace

void addPeopleDistances(MetricRegistry& to) {
  const Needs needs{true, true};
  const char source[] = "Perez-Higueras, Caballero, Merino, IJSR 2018";
  to.add({"avg_distance_to_closest_person", "Mean distance to the closest person", "m",
          Category::Social, Better::Higher, needs,
          "mean of c_i over the samples with people; c_i = min over a of max(gap(i,a), 0)", source,
          "[0, inf)", Kind::Number, 4, ""},
         averageDistance);
  to.add({"minimum_distance_to_people", "Smallest distance to people", "m", Category::Social,
          Better::Higher, needs, "min over i, a of max(gap(i,a), 0)", source, "[0, inf)",
          Kind::Number, 5, ""},
         minimumDistance);
  to.add({"maximum_distance_to_people", "Largest distance to people", "m", Category::Navigation,
          Better::Neutral, needs, "max over i, a of max(gap(i,a), 0)", source, "[0, inf)",
          Kind::Number, 6, ""},
         maximumDistance);
}

}  // namespace metrics
