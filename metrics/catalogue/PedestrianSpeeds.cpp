#include <cmath>
#include <limits>

#include "metrics/SeriesMetric.h"

namespace metrics {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool isOriginal(const MetricParameters& parameters) {
  return parameters.profile == Profile::Hunav2;
}

class SpeedSum : public Accumulator {
 public:
  explicit SpeedSum(const MetricParameters& parameters) : original_(isOriginal(parameters)) {}

  void add(const Recording& recording, std::size_t sample) override {
    const std::vector<Person>& people = recording.samples[sample].people;
    double speeds = 0.0;
    for (const Person& person : people) {
      speeds += person.speed;
    }
    sum_ += speeds;
    pairs_ += people.size();
    atFirst_ = sample == 0 ? people.size() : atFirst_;
    const double none = original_ ? 0.0 : kNaN;
    series_.push_back(people.empty() ? none : speeds / static_cast<double>(people.size()));
  }

  /// The original divides by the number of people at the first sample.
  MetricValue value() const {
    const std::size_t divisor = original_ ? series_.size() * atFirst_ : pairs_;
    if (divisor == 0 && original_) {
      return undefinedValue("ZeroDivisionError: nobody at the first sample");
    }
    return withSeries(divisor == 0 ? undefinedValue("nobody in the record")
                                   : numberValue(sum_ / static_cast<double>(divisor)),
                      series_);
  }

 private:
  bool original_;
  std::vector<double> series_;
  double sum_ = 0.0;
  std::size_t pairs_ = 0;  // of sample and person
  std::size_t atFirst_ = 0;
};

/// Speed of the closest person; nobody there: NaN, in the original 0.
double closestSpeed(const Sample& sample, const MetricParameters& parameters) {
  const bool original = isOriginal(parameters);
  double speed = original ? 0.0 : kNaN;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Person& person : sample.people) {
    const double value = original ? distance(sample.robot, person) : gap(sample.robot, person);
    if (value < nearest) {
      nearest = value;
      speed = person.speed;
    }
  }
  return speed;
}

MetricValue averageClosestSpeed(const std::vector<double>& speeds, const Recording& /*recording*/,
                                const MetricParameters& parameters) {
  double sum = 0.0;
  std::size_t met = 0;
  for (const double speed : speeds) {
    const bool isMet = !std::isnan(speed);
    sum += isMet ? speed : 0.0;
    met += isMet ? 1 : 0;
  }
  const std::size_t divisor = isOriginal(parameters) ? speeds.size() : met;
  return withSeries(divisor == 0 ? undefinedValue("nobody in the record")
                                 : numberValue(sum / static_cast<double>(divisor)),
                    speeds);
}

}  // namespace

void addPedestrianSpeeds(MetricRegistry& to) {
  const char source[] = "Katyal et al., IROS 2022";
  to.addStream({"avg_pedestrian_velocity", "Mean speed of people", "m/s", Category::Social,
                Better::Neutral, Needs{false, true}, "mean of |u_a| over all samples and people",
                source, "[0, inf)", Kind::Number, 23, ""},
               streamOf<SpeedSum>(
                   "",
                   [](const SpeedSum& sum, const Recording& /*recording*/,
                      const MetricParameters& /*parameters*/) { return sum.value(); },
                   [](const MetricParameters& parameters) {
                     return std::make_unique<SpeedSum>(parameters);
                   }));
  addSeriesMetric(
      to,
      {"avg_closest_pedestrian_velocity", "Mean speed of the closest person", "m/s",
       Category::Social, Better::Neutral, Needs{true, true},
       "mean of |u_a| of the person with the smallest gap, over the samples with people", source,
       "[0, inf)", Kind::Number, 24, ""},
      closestSpeed, averageClosestSpeed);
}

}  // namespace metrics
