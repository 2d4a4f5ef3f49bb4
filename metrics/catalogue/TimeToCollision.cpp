#include <cmath>
#include <limits>
#include <map>

#include "metrics/Interaction.h"
#include "metrics/Motion.h"
#include "metrics/SeriesMetric.h"

/// Threat and comfort: collisions ahead, passing, sideways acceleration.
namespace metrics {

namespace {

using Terms = std::vector<double>;

MetricValue average(const Terms& terms, const Recording& /*recording*/,
                    const MetricParameters& /*parameters*/) {
  double sum = 0.0;
  double count = 0.0;
  for (const double term : terms) {
    sum += std::isnan(term) ? 0.0 : term;
    count += std::isnan(term) ? 0.0 : 1.0;
  }
  return count > 0.0 ? withSeries(numberValue(sum / count), terms)
                     : undefinedValue("never on a collision course");
}

MetricValue exposed(const Terms& terms, const Recording& recording,
                    const MetricParameters& parameters) {
  return numberValue(
      timeWhere(recording, [&](std::size_t i) { return terms[i] < parameters.collisionHorizon; }));
}

MetricValue integrated(const Terms& terms, const Recording& recording,
                       const MetricParameters& parameters) {
  double sum = 0.0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    sum += terms[i] < parameters.collisionHorizon
               ? (parameters.collisionHorizon - terms[i]) * recording.interval(i)
               : 0.0;
  }
  return numberValue(sum);
}

/// The smallest gap of each person who comes near.
class PassingDistance : public Accumulator {
 public:
  explicit PassingDistance(const MetricParameters& parameters)
      : limit_(parameters.socialDistance) {}

  void add(const Recording& recording, std::size_t sample) override {
    const Sample& now = recording.samples[sample];
    for (const Person& person : now.people) {
      const double reach = limit_ + now.robot.radius + person.radius + 1e-6;
      if ((person.position - now.robot.position).squaredNorm() > reach * reach) {
        continue;
      }
      const double space = gap(now.robot, person);
      const auto [found, isNew] = closest_.emplace(person.id, space);
      found->second = space < found->second ? space : found->second;
    }
  }

  MetricValue value() const {
    double sum = 0.0;
    double count = 0.0;
    for (const auto& [id, space] : closest_) {
      sum += space < limit_ ? space : 0.0;
      count += space < limit_ ? 1.0 : 0.0;
    }
    return count > 0.0 ? numberValue(sum / count) : undefinedValue("nobody was passed");
  }

 private:
  double limit_;
  std::map<int, double> closest_;
};

/// Speed at which the closest person and the robot near each other, of samples in personal space.
double approach(const Sample& sample, const MetricParameters& parameters) {
  double closest = std::numeric_limits<double>::infinity();
  double value = std::numeric_limits<double>::quiet_NaN();
  for (const Person& person : sample.people) {
    const double space = gap(sample.robot, person);
    const Vec2 between = person.position - sample.robot.position;
    const double separation = lengthOf(between);
    if (space < closest && space < parameters.personalDistance && separation > 0.0) {
      closest = space;
      value = between.dot(sample.robot.velocity - person.velocity) / separation;
    }
  }
  return value;
}

MetricValue fastest(const Terms& terms, const Recording& /*recording*/,
                    const MetricParameters& /*parameters*/) {
  const double value = largestTerm(terms);
  return std::isnan(value) ? undefinedValue("nobody in personal space")
                           : numberValue(std::fmax(value, 0.0));
}

double sideways(const Sample& sample, const MetricParameters& /*parameters*/) {
  return std::fabs(sample.robot.speed * sample.robot.omega);
}

MetricValue largest(const Terms& terms, const Recording& /*recording*/,
                    const MetricParameters& /*parameters*/) {
  return withSeries(numberValue(largestTerm(terms)), terms);
}

MetricInfo info(const char* key, const char* name, const char* unit, Category category,
                Better better) {
  MetricInfo made;
  made.key = key;
  made.name = name;
  made.unit = unit;
  made.category = category;
  made.better = better;
  made.needs = Needs{true, true};
  made.range = "[0, inf)";
  return made;
}

}  // namespace

void addTimeToCollision(MetricRegistry& to) {
  const char source[] = "Minderhoud and Bovy 2001";
  MetricInfo mean = info("avg_time_to_collision", "Mean time to collision", "s", Category::Safety,
                         Better::Higher);
  mean.formula = "mean over the samples on a collision course of min over a of ttc";
  mean.source = "Francis et al. 2025; SocNavGym";
  addSeriesMetric(to, mean, collisionTerm, average);
  MetricInfo exposure = info("time_exposed_to_collision", "Time with a collision ahead", "s",
                             Category::Safety, Better::Lower);
  exposure.formula = "sum of dt_i with min over a of ttc < collision_horizon";
  exposure.source = source;
  exposure.range = "[0, T]";
  addSeriesMetric(to, exposure, collisionTerm, exposed);
  MetricInfo integral = info("time_integrated_to_collision", "Threat of collisions", "s²",
                             Category::Safety, Better::Lower);
  integral.formula = "sum of (collision_horizon - ttc) dt_i where ttc < collision_horizon";
  integral.source = source;
  addSeriesMetric(to, integral, collisionTerm, integrated);
  MetricInfo passing =
      info("avg_passing_distance", "Mean passing distance", "m", Category::Social, Better::Higher);
  passing.formula = "mean over people of their smallest gap, of those with it < social_distance";
  passing.source = "Pacchierotti et al. 2006";
  passing.range = "(-inf, social_distance)";
  to.addStream(passing,
               streamOf<PassingDistance>(
                   "",
                   [](const PassingDistance& distances, const Recording& /*recording*/,
                      const MetricParameters& /*parameters*/) { return distances.value(); },
                   [](const MetricParameters& parameters) {
                     return std::make_unique<PassingDistance>(parameters);
                   }));
  MetricInfo nearing = info("max_approach_speed", "Largest speed of approach", "m/s",
                            Category::Social, Better::Lower);
  nearing.formula =
      "max of the closing speed with the closest person, of samples with gap < personal_distance";
  nearing.source = "Butler and Agah 2001";
  addSeriesMetric(to, nearing, approach, fastest);
  MetricInfo lateral = info("max_lateral_acceleration", "Largest sideways acceleration", "m/s²",
                            Category::Motion, Better::Lower);
  lateral.needs = Needs{};
  lateral.formula = "max of |s_i w_i|";
  lateral.source = "ISO 2631, comfort of rides";
  addSeriesMetric(to, lateral, sideways, largest);
}

}  // namespace metrics
