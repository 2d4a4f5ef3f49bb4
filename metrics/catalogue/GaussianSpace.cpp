#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/Motion.h"
#include "metrics/SeriesMetric.h"

namespace metrics {

namespace {

/// How far outside the space of a person the robot stands, 0 at its centre: the negative exponent
/// of a Gaussian that is longer ahead of who walks and shorter behind (Kirby).
double outsideness(const Person& person, const Robot& robot) {
  const Vec2 offset = robot.position - person.position;
  const Vec2 local(person.pair.ahead.dot(offset), base::cross(person.pair.ahead, offset));
  const double front = std::max(2.0 * person.speed, 0.5);  // variances [m^2]
  const double side = front * 2.0 / 3.0;
  const double along = local.x() > 0.0 ? front : front / 2.0;
  return local.x() * local.x() / (2.0 * along) + local.y() * local.y() / (2.0 * side);
}

/// Not above the same: the variance ahead is the largest.
double leastOutsideness(const Person& person, const Robot& robot) {
  constexpr double kSlack = 1.0 - 1e-9;
  return kSlack * (robot.position - person.position).squaredNorm() /
         (2.0 * std::max(2.0 * person.speed, 0.5));
}

using Terms = std::vector<double>;

/// Deepest intrusion of a sample; NaN without people.
double deepest(const Sample& sample, const MetricParameters& /*parameters*/) {
  double least = std::numeric_limits<double>::infinity();
  for (const Person& person : sample.people) {
    if (leastOutsideness(person, sample.robot) < least) {
      least = std::min(least, outsideness(person, sample.robot));
    }
  }
  return sample.people.empty() ? std::numeric_limits<double>::quiet_NaN() : std::exp(-least);
}

MetricValue average(const Terms& values, const Recording& recording,
                    const MetricParameters& /*parameters*/) {
  double sum = 0.0;
  double time = 0.0;
  std::vector<double> series;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool defined = !std::isnan(values[i]);
    sum += defined ? values[i] * recording.interval(i) : 0.0;
    time += defined ? recording.interval(i) : 0.0;
    series.push_back(100.0 * values[i]);
  }
  return withSeries(numberValue(time > 0.0 ? 100.0 * sum / time : 0.0), std::move(series));
}

MetricValue extreme(const Terms& values, bool wantLargest) {
  std::optional<double> found;
  for (const double value : values) {
    if (!std::isnan(value) && (!found || (wantLargest ? value > *found : value < *found))) {
      found = value;
    }
  }
  return found ? numberValue(100.0 * *found) : undefinedValue("nobody in the record");
}

MetricValue smallest(const Terms& values, const Recording& /*recording*/,
                     const MetricParameters& /*parameters*/) {
  return extreme(values, false);
}

MetricValue largest(const Terms& values, const Recording& /*recording*/,
                    const MetricParameters& /*parameters*/) {
  return extreme(values, true);
}

MetricValue timeAbove(const Terms& values, const Recording& recording,
                      const MetricParameters& parameters) {
  const double total = timeWhere(recording, [&](std::size_t i) { return !std::isnan(values[i]); });
  const double time =
      timeWhere(recording, [&](std::size_t i) { return values[i] > parameters.gaussianThreshold; });
  return numberValue(total > 0.0 ? 100.0 * time / total : 0.0);
}

}  // namespace

void addGaussianSpace(MetricRegistry& to) {
  const Needs needs{true, true};
  const char source[] = "SRPB (Kirby's model)";
  const std::string key = "personal_space_intrusion_gaussian";
  const std::string name = "Intrusion into the Gaussian personal space";
  addSeriesMetric(
      to,
      {key, name, "%", Category::Social, Better::Lower, needs,
       "time-weighted mean of max over a of exp(-(x^2/2Vx + y^2/2Vs)); Vf = max(2 |u|, 0.5), "
       "Vs = 2/3 Vf, Vx = Vf ahead and Vf/2 behind",
       source, "[0, 100]", Kind::Number, 0, ""},
      deepest, average);
  addSeriesMetric(to,
                  {key + "_min", name + ", smallest", "%", Category::Social, Better::Lower, needs,
                   "min over samples with people", source, "[0, 100]", Kind::Number, 0, ""},
                  deepest, smallest);
  addSeriesMetric(to,
                  {key + "_max", name + ", largest", "%", Category::Social, Better::Lower, needs,
                   "max over samples with people", source, "[0, 100]", Kind::Number, 0, ""},
                  deepest, largest);
  addSeriesMetric(to,
                  {key + "_above", "Time inside the Gaussian personal space", "%", Category::Social,
                   Better::Lower, needs, "share of the time with people above gaussian_threshold",
                   source, "[0, 100]", Kind::Number, 0, ""},
                  deepest, timeAbove);
}

}  // namespace metrics
