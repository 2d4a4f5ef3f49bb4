#include <algorithm>
#include <cmath>

#include "metrics/Interaction.h"
#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

namespace metrics {

namespace {

MetricValue minimumTimeToCollision(const Recording& recording,
                                   const MetricParameters& /*parameters*/) {
  std::optional<double> shortest;
  for (const Sample& sample : recording.samples) {
    for (const Person& person : sample.people) {
      const std::optional<double> time = timeToCollision(sample.robot, person);
      if (time && (!shortest || *time < *shortest)) {
        shortest = time;
      }
    }
  }
  return shortest ? numberValue(*shortest) : infiniteValue("never on a collision course");
}

double percentOfSamples(const Recording& recording, double count) {
  return 100.0 * count / static_cast<double>(recording.size());
}

MetricValue spaceCompliance(const Recording& recording, const MetricParameters& parameters) {
  double count = 0.0;
  for (const Sample& sample : recording.samples) {
    const std::optional<double> closest = closestGap(sample);
    count += !closest || *closest >= parameters.complianceDistance ? 1.0 : 0.0;
  }
  return numberValue(percentOfSamples(recording, count));
}

MetricValue discomfortFrequency(const Recording& recording, const MetricParameters& parameters) {
  double count = 0.0;
  for (const Sample& sample : recording.samples) {
    const std::optional<double> closest = closestGap(sample);
    count += closest && *closest < parameters.discomfortDistance ? 1.0 : 0.0;
  }
  return numberValue(percentOfSamples(recording, count));
}

MetricValue discomfortDistance(const Recording& recording, const MetricParameters& parameters) {
  double sum = 0.0;
  double count = 0.0;
  for (const Sample& sample : recording.samples) {
    const std::optional<double> closest = closestGap(sample);
    if (closest && *closest < parameters.discomfortDistance) {
      sum += *closest;
      count += 1.0;
    }
  }
  return count > 0.0 ? numberValue(sum / count) : undefinedValue("nobody came that close");
}

bool isInPersonalRadius(const Sample& sample, const MetricParameters& parameters) {
  return std::any_of(sample.people.begin(), sample.people.end(), [&](const Person& person) {
    return distance(sample.robot, person) <= parameters.personalRadius;
  });
}

MetricValue timeInPersonalSpace(const Recording& recording, const MetricParameters& parameters) {
  return numberValue(timeWhere(recording, [&](std::size_t i) {
    return isInPersonalRadius(recording.samples[i], parameters);
  }));
}

MetricValue speedInPersonalSpace(const Recording& recording, const MetricParameters& parameters) {
  double sum = 0.0;
  double count = 0.0;
  for (const Sample& sample : recording.samples) {
    if (isInPersonalRadius(sample, parameters)) {
      sum += lengthOf(sample.robot.velocity);
      count += 1.0;
    }
  }
  return numberValue(count > 0.0 ? sum / count : 0.0);
}

MetricValue speedInIntimateSpace(const Recording& recording, const MetricParameters& parameters) {
  double fastest = 0.0;
  for (const Sample& sample : recording.samples) {
    const std::optional<double> closest = closestGap(sample);
    if (closest && *closest < parameters.intimateDistance) {
      fastest = std::max(fastest, lengthOf(sample.robot.velocity));
    }
  }
  return numberValue(fastest);
}

void addTimesAndSpeeds(MetricRegistry& to) {
  const Needs needs{true, true};
  to.add({"time_in_personal_space", "Time in somebody's personal space", "s", Category::Social,
          Better::Lower, needs,
          "sum of dt_i with a person's centre within personal_radius of the robot's", "Arena",
          "[0, T]", Kind::Number, 0, ""},
         timeInPersonalSpace);
  to.add({"avg_speed_in_personal_space", "Mean speed in personal space", "m/s", Category::Social,
          Better::Lower, needs, "mean of |v_i| over those samples, 0 if none", "Arena", "[0, inf)",
          Kind::Number, 0, ""},
         speedInPersonalSpace);
  to.add(
      {"max_speed_in_intimate_space", "Largest speed in intimate space", "m/s", Category::Social,
       Better::Lower, needs, "max of |v_i| where the smallest gap < intimate_distance, 0 if none",
       "Arena", "[0, inf)", Kind::Number, 0, ""},
      speedInIntimateSpace);
}

}  // namespace

void addPersonalSpace(MetricRegistry& to) {
  const Needs needs{true, true};
  to.add({"min_time_to_collision", "Smallest time to collision", "s", Category::Safety,
          Better::Higher, needs, "min over i, a of ttc, infinite if never on a collision course",
          "Francis et al. 2025; SocNavBench; SocNavGym", "[0, inf]", Kind::Number, 0, ""},
         minimumTimeToCollision);
  to.add({"space_compliance", "Personal space kept", "%", Category::Social, Better::Higher, needs,
          "share of samples with the smallest gap >= compliance_distance or nobody there",
          "Francis et al. 2025; SocNavGym", "[0, 100]", Kind::Number, 0, ""},
         spaceCompliance);
  to.add({"discomfort_frequency", "Uncomfortably close", "%", Category::Social, Better::Lower,
          needs, "share of samples with the smallest gap < discomfort_distance", "CrowdNav",
          "[0, 100]", Kind::Number, 0, ""},
         discomfortFrequency);
  to.add({"discomfort_distance_avg", "Mean distance when uncomfortably close", "m",
          Category::Social, Better::Higher, needs,
          "mean of the smallest gap over the samples with it < discomfort_distance", "CrowdNav",
          "[0, inf)", Kind::Number, 0, ""},
         discomfortDistance);
  addTimesAndSpeeds(to);
}

}  // namespace metrics
