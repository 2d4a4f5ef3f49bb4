#include <algorithm>
#include <cmath>

#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

namespace metrics {

namespace {

/// How deep the robot stands in the space of a person, 1 at its centre: a Gaussian that is longer
/// ahead of who walks and shorter behind (Kirby).
double intrusion(const Person& person, const Robot& robot) {
  const Vec2 local = base::Pose2{person.position, person.heading}.toLocal(robot.position);
  const double front = std::max(2.0 * person.speed, 0.5);  // variances [m^2]
  const double side = front * 2.0 / 3.0;
  const double along = local.x() > 0.0 ? front : front / 2.0;
  return std::exp(-(local.x() * local.x() / (2.0 * along) + local.y() * local.y() / (2.0 * side)));
}

/// Deepest intrusion per sample; none without people.
std::vector<std::optional<double>> intrusions(const Recording& recording) {
  std::vector<std::optional<double>> values;
  for (const Sample& sample : recording.samples) {
    std::optional<double> deepest;
    for (const Person& person : sample.people) {
      deepest = std::max(deepest.value_or(0.0), intrusion(person, sample.robot));
    }
    values.push_back(deepest);
  }
  return values;
}

MetricValue average(const Recording& recording, const MetricParameters& /*parameters*/) {
  const std::vector<std::optional<double>> values = intrusions(recording);
  double sum = 0.0;
  double time = 0.0;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    if (values[i]) {
      sum += *values[i] * recording.interval(i);
      time += recording.interval(i);
    }
  }
  std::vector<double> series;
  for (const std::optional<double>& value : values) {
    series.push_back(100.0 * value.value_or(0.0));
  }
  return withSeries(numberValue(time > 0.0 ? 100.0 * sum / time : 0.0), std::move(series));
}

MetricValue extreme(const Recording& recording, bool largest) {
  std::optional<double> found;
  for (const std::optional<double>& value : intrusions(recording)) {
    if (value && (!found || (largest ? *value > *found : *value < *found))) {
      found = value;
    }
  }
  return found ? numberValue(100.0 * *found) : undefinedValue("nobody in the record");
}

MetricValue smallest(const Recording& recording, const MetricParameters& /*parameters*/) {
  return extreme(recording, false);
}

MetricValue largest(const Recording& recording, const MetricParameters& /*parameters*/) {
  return extreme(recording, true);
}

MetricValue timeAbove(const Recording& recording, const MetricParameters& parameters) {
  const std::vector<std::optional<double>> values = intrusions(recording);
  const double total = timeWhere(recording, [&](std::size_t i) { return values[i].has_value(); });
  const double time = timeWhere(recording, [&](std::size_t i) {
    return values[i].value_or(0.0) > parameters.gaussianThreshold;
  });
  return numberValue(total > 0.0 ? 100.0 * time / total : 0.0);
}

}  // namespace

void addGaussianSpace(MetricRegistry& to) {
  const Needs needs{true, true};
  const char source[] = "SRPB (Kirby's model)";
  const std::string key = "personal_space_intrusion_gaussian";
  const std::string name = "Intrusion into the Gaussian personal space";
  to.add({key, name, "%", Category::Social, Better::Lower, needs,
          "time-weighted mean of max over a of exp(-(x^2/2Vx + y^2/2Vs)); Vf = max(2 |u|, 0.5), "
          "Vs = 2/3 Vf, Vx = Vf ahead and Vf/2 behind",
          source, "[0, 100]", Kind::Number, 0, ""},
         average);
  to.add({key + "_min", name + ", smallest", "%", Category::Social, Better::Lower, needs,
          "min over samples with people", source, "[0, 100]", Kind::Number, 0, ""},
         smallest);
  to.add({key + "_max", name + ", largest", "%", Category::Social, Better::Lower, needs,
          "max over samples with people", source, "[0, 100]", Kind::Number, 0, ""},
         largest);
  to.add({key + "_above", "Time inside the Gaussian personal space", "%", Category::Social,
          Better::Lower, needs, "share of the time with people above gaussian_threshold", source,
          "[0, 100]", Kind::Number, 0, ""},
         timeAbove);
}

}  // namespace metrics
