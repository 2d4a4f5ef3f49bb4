#include <cmath>
#include <limits>

#include "metrics/TermSums.h"

namespace metrics {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class SpeedSum : public Accumulator {
 public:
  void add(const Instant& at) override {
    const std::vector<Person>& people = at.now.people;
    double speeds = 0.0;
    for (const Person& person : people) {
      speeds += person.speed;
    }
    sum_ += speeds;
    pairs_ += people.size();
    atFirst_ = at.before == nullptr ? people.size() : atFirst_;
    const double none = at.isOriginal() ? 0.0 : kNaN;
    series_.add(at, people.empty() ? none : speeds / static_cast<double>(people.size()));
  }

  /// The original divides by the number of people at the first sample.
  MetricValue mean(const Instant& last) const {
    const std::size_t divisor = last.isOriginal() ? last.count() * atFirst_ : pairs_;
    if (divisor == 0 && last.isOriginal()) {
      return undefinedValue("ZeroDivisionError: nobody at the first sample");
    }
    return withSeries(divisor == 0 ? undefinedValue("nobody in the record")
                                   : numberValue(sum_ / static_cast<double>(divisor)),
                      series_.values());
  }

 private:
  SeriesColumn series_;
  double sum_ = 0.0;
  std::size_t pairs_ = 0;  // of sample and person
  std::size_t atFirst_ = 0;
};

/// Speed of the closest person; nobody there: NaN, in the original 0.
double closestSpeed(const Sample& sample, const MetricParameters& parameters) {
  const bool original = parameters.profile == Profile::Hunav2;
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

MetricValue averageClosestSpeed(const Figures& speeds, const Instant& /*last*/) {
  return withSeries(speeds.count() > 0.0 ? numberValue(speeds.sum() / speeds.count())
                                         : undefinedValue("nobody in the record"),
                    speeds.series());
}

}  // namespace

void addPedestrianSpeeds(MetricRegistry& to) {
  const char source[] = "Katyal et al., IROS 2022";
  to.add({"avg_pedestrian_velocity", "Mean speed of people", "m/s", Category::Social,
          Better::Neutral, Needs{false, true}, "mean of |u_a| over all samples and people", source,
          "[0, inf)", Kind::Number, 23, ""},
         streamOf<SpeedSum>(&SpeedSum::mean));
  to.add({"avg_closest_pedestrian_velocity", "Mean speed of the closest person", "m/s",
          Category::Social, Better::Neutral, Needs{true, true},
          "mean of |u_a| of the person with the smallest gap, over the samples with people", source,
          "[0, inf)", Kind::Number, 24, ""},
         figuresOf<closestSpeed>(averageClosestSpeed));
}

}  // namespace metrics
