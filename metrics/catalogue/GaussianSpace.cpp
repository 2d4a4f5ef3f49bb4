#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/TermSums.h"

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

std::vector<double> inPercent(std::vector<double> values) {
  for (double& value : values) {
    value *= 100.0;
  }
  return values;
}

MetricValue average(const Figures& depths, const Instant& /*last*/) {
  const double mean = depths.time() > 0.0 ? 100.0 * depths.integral() / depths.time() : 0.0;
  return withSeries(numberValue(mean), inPercent(depths.series()));
}

MetricValue percentOf(double depth) {
  return std::isnan(depth) ? undefinedValue("nobody in the record") : numberValue(100.0 * depth);
}

MetricValue smallest(const Figures& depths, const Instant& /*last*/) {
  return percentOf(depths.least());
}

MetricValue largest(const Figures& depths, const Instant& /*last*/) {
  return percentOf(depths.largest());
}

/// Share of the time with people.
class DeepTime : public Accumulator {
 public:
  void add(const Instant& at) override {
    const double depth = at.term(deepest);
    peopled_.add(at, !std::isnan(depth));
    deep_.add(at, depth > at.parameters.gaussianThreshold);
  }
  MetricValue share(const Instant& /*last*/) const {
    const double total = peopled_.value();
    return numberValue(total > 0.0 ? 100.0 * deep_.value() / total : 0.0);
  }

 private:
  HeldTime peopled_, deep_;
};

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
         figuresOf<deepest>(average));
  to.add({key + "_min", name + ", smallest", "%", Category::Social, Better::Lower, needs,
          "min over samples with people", source, "[0, 100]", Kind::Number, 0, ""},
         figuresOf<deepest>(smallest));
  to.add({key + "_max", name + ", largest", "%", Category::Social, Better::Lower, needs,
          "max over samples with people", source, "[0, 100]", Kind::Number, 0, ""},
         figuresOf<deepest>(largest));
  to.add({key + "_above", "Time inside the Gaussian personal space", "%", Category::Social,
          Better::Lower, needs, "share of the time with people above gaussian_threshold", source,
          "[0, 100]", Kind::Number, 0, ""},
         streamOf<DeepTime>(&DeepTime::share));
}

}  // namespace metrics
