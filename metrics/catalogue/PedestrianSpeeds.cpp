#include <limits>

#include "metrics/MetricRegistry.h"

namespace metrics {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

MetricValue averageSpeed(const Recording& recording, const MetricParameters& parameters) {
  const bool original = parameters.profile == Profile::Hunav2;
  std::vector<double> series;
  double sum = 0.0;
  std::size_t pairs = 0;
  for (const Sample& sample : recording.samples) {
    double speeds = 0.0;
    for (const Person& person : sample.people) {
      speeds += person.speed;
    }
    const std::size_t count = sample.people.size();
    sum += speeds;
    pairs += count;
    series.push_back(count > 0 ? speeds / static_cast<double>(count) : (original ? 0.0 : kNaN));
  }
  const std::size_t divisor =
      original ? recording.size() * recording.samples.front().people.size() : pairs;
  if (divisor == 0 && original) {
    return undefinedValue("ZeroDivisionError: nobody at the first sample");
  }
  MetricValue value = divisor == 0 ? undefinedValue("nobody in the record")
                                   : numberValue(sum / static_cast<double>(divisor));
  return withSeries(std::move(value), std::move(series));
}

const Person* closestPerson(const Sample& sample, bool byCentre) {
  const Person* closest = nullptr;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Person& person : sample.people) {
    const double value = byCentre ? distance(sample.robot, person) : gap(sample.robot, person);
    if (value < nearest) {
      nearest = value;
      closest = &person;
    }
  }
  return closest;
}

MetricValue averageClosestSpeed(const Recording& recording, const MetricParameters& parameters) {
  const bool original = parameters.profile == Profile::Hunav2;
  std::vector<double> series;
  double sum = 0.0;
  std::size_t met = 0;
  for (const Sample& sample : recording.samples) {
    const Person* person = closestPerson(sample, original);
    sum += person != nullptr ? person->speed : 0.0;
    met += person != nullptr ? 1 : 0;
    series.push_back(person != nullptr ? person->speed : (original ? 0.0 : kNaN));
  }
  const std::size_t divisor = original ? recording.size() : met;
  MetricValue value = divisor == 0 ? undefinedValue("nobody in the record")
                                   : numberValue(sum / static_cast<double>(divisor));
  return withSeries(std::move(value), std::move(series));
}

}  // namespace

void addPedestrianSpeeds(MetricRegistry& to) {
  const char source[] = "Katyal et al., IROS 2022";
  to.add({"avg_pedestrian_velocity", "Mean speed of people", "m/s", Category::Social,
          Better::Neutral, Needs{false, true}, "mean of |u_a| over all samples and people", source,
          "[0, inf)", Kind::Number, 23, ""},
         averageSpeed);
  to.add({"avg_closest_pedestrian_velocity", "Mean speed of the closest person", "m/s",
          Category::Social, Better::Neutral, Needs{true, true},
          "mean of |u_a| of the person with the smallest gap, over the samples with people", source,
          "[0, inf)", Kind::Number, 24, ""},
         averageClosestSpeed);
}

}  // namespace metrics
