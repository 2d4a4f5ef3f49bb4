#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/Interaction.h"
#include "metrics/Motion.h"
#include "metrics/SeriesMetric.h"

namespace metrics {

namespace {

using Terms = std::vector<double>;

MetricValue minimumTimeToCollision(const Terms& times, const Recording& /*recording*/,
                                   const MetricParameters& /*parameters*/) {
  std::optional<double> shortest;
  for (const double time : times) {
    if (!std::isnan(time) && (!shortest || time < *shortest)) {
      shortest = time;
    }
  }
  return shortest ? numberValue(*shortest) : infiniteValue("never on a collision course");
}

template <class Holds>
MetricValue percentWhere(const Terms& terms, Holds holds) {
  const auto count = std::count_if(terms.begin(), terms.end(), holds);
  return numberValue(100.0 * static_cast<double>(count) / static_cast<double>(terms.size()));
}

MetricValue spaceCompliance(const Terms& closest, const Recording& /*recording*/,
                            const MetricParameters& parameters) {
  return percentWhere(closest, [&](double distance) {
    return std::isnan(distance) || distance >= parameters.complianceDistance;
  });
}

MetricValue discomfortFrequency(const Terms& closest, const Recording& /*recording*/,
                                const MetricParameters& parameters) {
  return percentWhere(closest,
                      [&](double distance) { return distance < parameters.discomfortDistance; });
}

MetricValue discomfortDistance(const Terms& closest, const Recording& /*recording*/,
                               const MetricParameters& parameters) {
  double sum = 0.0;
  double count = 0.0;
  for (const double distance : closest) {
    if (distance < parameters.discomfortDistance) {
      sum += distance;
      count += 1.0;
    }
  }
  return count > 0.0 ? numberValue(sum / count) : undefinedValue("nobody came that close");
}

/// 1 where a person's centre lies within the personal radius.
double personalTerm(const Sample& sample, const MetricParameters& parameters) {
  const bool near =
      std::any_of(sample.people.begin(), sample.people.end(), [&](const Person& person) {
        return distance(sample.robot, person) <= parameters.personalRadius;
      });
  return near ? 1.0 : 0.0;
}

MetricValue timeInPersonalSpace(const Terms& near, const Recording& recording,
                                const MetricParameters& /*parameters*/) {
  return numberValue(timeWhere(recording, [&](std::size_t i) { return near[i] > 0.0; }));
}

MetricValue speedInPersonalSpace(const Terms& near, const Recording& recording,
                                 const MetricParameters& /*parameters*/) {
  double sum = 0.0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    sum += near[i] > 0.0 ? lengthOf(recording.samples[i].robot.velocity) : 0.0;
  }
  const double count = sumOf(near);
  return numberValue(count > 0.0 ? sum / count : 0.0);
}

MetricValue speedInIntimateSpace(const Terms& closest, const Recording& recording,
                                 const MetricParameters& parameters) {
  double fastest = 0.0;
  for (std::size_t i = 0; i < closest.size(); ++i) {
    if (closest[i] < parameters.intimateDistance) {
      fastest = std::max(fastest, lengthOf(recording.samples[i].robot.velocity));
    }
  }
  return numberValue(fastest);
}

void addTimesAndSpeeds(MetricRegistry& to) {
  const Needs needs{true, true};
  addSeriesMetric(to,
                  {"time_in_personal_space", "Time in somebody's personal space", "s",
                   Category::Social, Better::Lower, needs,
                   "sum of dt_i with a person's centre within personal_radius of the robot's",
                   "Arena", "[0, T]", Kind::Number, 0, ""},
                  personalTerm, timeInPersonalSpace);
  addSeriesMetric(
      to,
      {"avg_speed_in_personal_space", "Mean speed in personal space", "m/s", Category::Social,
       Better::Lower, needs, "mean of |v_i| over those samples, 0 if none", "Arena", "[0, inf)",
       Kind::Number, 0, ""},
      personalTerm, speedInPersonalSpace);
  addSeriesMetric(
      to,
      {"max_speed_in_intimate_space", "Largest speed in intimate space", "m/s", Category::Social,
       Better::Lower, needs, "max of |v_i| where the smallest gap < intimate_distance, 0 if none",
       "Arena", "[0, inf)", Kind::Number, 0, ""},
      closestGapTerm, speedInIntimateSpace);
}

}  // namespace

void addPersonalSpace(MetricRegistry& to) {
  const Needs needs{true, true};
  addSeriesMetric(
      to,
      {"min_time_to_collision", "Smallest time to collision", "s", Category::Safety, Better::Higher,
       needs, "min over i, a of ttc, infinite if never on a collision course",
       "Francis et al. 2025; SocNavBench; SocNavGym", "[0, inf]", Kind::Number, 0, ""},
      collisionTerm, minimumTimeToCollision);
  addSeriesMetric(
      to,
      {"space_compliance", "Personal space kept", "%", Category::Social, Better::Higher, needs,
       "share of samples with the smallest gap >= compliance_distance or nobody there",
       "Francis et al. 2025; SocNavGym", "[0, 100]", Kind::Number, 0, ""},
      closestGapTerm, spaceCompliance);
  addSeriesMetric(
      to,
      {"discomfort_frequency", "Uncomfortably close", "%", Category::Social, Better::Lower, needs,
       "share of samples with the smallest gap < discomfort_distance", "CrowdNav", "[0, 100]",
       Kind::Number, 0, ""},
      closestGapTerm, discomfortFrequency);
  addSeriesMetric(to,
                  {"discomfort_distance_avg", "Mean distance when uncomfortably close", "m",
                   Category::Social, Better::Higher, needs,
                   "mean of the smallest gap over the samples with it < discomfort_distance",
                   "CrowdNav", "[0, inf)", Kind::Number, 0, ""},
                  closestGapTerm, discomfortDistance);
  addTimesAndSpeeds(to);
}

}  // namespace metrics
