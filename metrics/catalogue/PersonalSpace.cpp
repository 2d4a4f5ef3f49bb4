#include <algorithm>
#include <cmath>

#include "metrics/TermSums.h"

/// How near people are.
namespace metrics {

namespace {

MetricValue amongPeople(double value, const Instant& last) {
  const char* why = last.isOriginal() ? "ValueError: nobody in the record" : kNobody;
  return std::isnan(value) ? undefinedValue(why) : value;
}

/// The original's series leaves out samples without people.
MetricValue averageDistance(const Figures& closest, const Instant& last) {
  if (!last.isOriginal()) {
    return closest.meanWithSeries();
  }
  std::vector<double> series = closest.series();
  series.erase(std::remove_if(series.begin(), series.end(),
                              [](double distance) { return std::isnan(distance); }),
               series.end());
  return withSeries(closest.sum() / static_cast<double>(last.count()), std::move(series));
}

MetricValue minimumDistance(const Figures& closest, const Instant& last) {
  return amongPeople(closest.least(), last);
}

double farthestGap(const Instant& at) {
  double farthest = kNaN;
  for (const Person& person : at.now.people) {
    farthest = std::fmax(farthest, gap(at.now.robot, person));
  }
  return farthest;
}

MetricValue maximumDistance(const Figures& farthest, const Instant& last) {
  const double largest = farthest.largest();
  return amongPeople(last.isOriginal() ? largest : std::max(largest, 0.0), last);
}

void addPeopleDistances(MetricRegistry& to) {
  const char source[] = "Perez-Higueras, Caballero, Merino, IJSR 2018";
  const MetricFamily own{to, Category::Social, Better::Higher, {true, true}, source};
  own.add("avg_distance_to_closest_person", "Mean distance to the closest person", "m",
          "mean of c_i over the samples with people; c_i = min over a of max(gap(i,a), 0)",
          seriesFiguresOf<closestGapTerm>(averageDistance, kNobody), 4);
  own.add("minimum_distance_to_people", "Smallest distance to people", "m",
          "min over i, a of max(gap(i,a), 0)", figuresOf<closestGapTerm>(minimumDistance), 5);
  to.add({"maximum_distance_to_people", "Largest distance to people", "m", Category::Navigation,
          Better::Neutral, Needs{true, true}, "max over i, a of max(gap(i,a), 0)", source,
          "[0, inf)", Kind::Number, 6},
         figuresOf<farthestGap>(maximumDistance));
}

MetricValue minimumTimeToCollision(const Figures& times) {
  return times.count() > 0.0 ? times.least() : infiniteValue("never on a collision course");
}

bool complies(const Instant& at) {
  return !(at.term(closestGapTerm) < at.parameters.complianceDistance);
}

bool isUncomfortable(const Instant& at) {
  return at.term(closestGapTerm) < at.parameters.discomfortDistance;
}

double uncomfortableGap(const Instant& at) {
  return isUncomfortable(at) ? at.term(closestGapTerm) : kNaN;
}

/// A person's centre lies within the personal radius.
bool isInPersonalSpace(const Instant& at) {
  const std::vector<Person>& people = at.now.people;
  return std::any_of(people.begin(), people.end(), [&at](const Person& person) {
    return distance(at.now.robot, person) <= at.parameters.personalRadius;
  });
}

double speedInPersonalSpace(const Instant& at) {
  return isInPersonalSpace(at) ? lengthOf(at.now.robot.velocity) : kNaN;
}

double speedInIntimateSpace(const Instant& at) {
  return at.term(closestGapTerm) < at.parameters.intimateDistance ? lengthOf(at.now.robot.velocity)
                                                                  : kNaN;
}

double meanOrZero(const Figures& speeds) {
  return std::fmax(speeds.mean(), 0.0);
}

double largestOrZero(const Figures& speeds) {
  return std::fmax(speeds.largest(), 0.0);
}

void addTimesAndSpeeds(MetricRegistry& to) {
  const Needs needs{true, true};
  to.add({"time_in_personal_space", "Time in somebody's personal space", "s", Category::Social,
          Better::Lower, needs,
          "sum of dt_i with a person's centre within personal_radius of the robot's", "Arena",
          "[0, T]"},
         timesOf<isInPersonalSpace>(&Times::time));
  const MetricFamily speeds{to, Category::Social, Better::Lower, needs, "Arena"};
  speeds.add("avg_speed_in_personal_space", "Mean speed in personal space", "m/s",
             "mean of |v_i| over those samples, 0 if none",
             figuresOf<speedInPersonalSpace>(meanOrZero));
  speeds.add("max_speed_in_intimate_space", "Largest speed in intimate space", "m/s",
             "max of |v_i| where the smallest gap < intimate_distance, 0 if none",
             figuresOf<speedInIntimateSpace>(largestOrZero));
}

}  // namespace

void addPersonalSpace(MetricRegistry& to) {
  addPeopleDistances(to);
  const Needs needs{true, true};
  to.add({"min_time_to_collision", "Smallest time to collision", "s", Category::Safety,
          Better::Higher, needs, "min over i, a of ttc, infinite if never on a collision course",
          "Francis et al. 2025; SocNavBench; SocNavGym", "[0, inf]"},
         figuresOf<collisionTerm>(minimumTimeToCollision));
  to.add({"space_compliance", "Personal space kept", "%", Category::Social, Better::Higher, needs,
          "share of samples with the smallest gap >= compliance_distance or nobody there",
          "Francis et al. 2025; SocNavGym", "[0, 100]"},
         timesOf<complies>(&Times::percentOfSamples));
  to.add(
      {"discomfort_frequency", "Uncomfortably close", "%", Category::Social, Better::Lower, needs,
       "share of samples with the smallest gap < discomfort_distance", "CrowdNav", "[0, 100]"},
      timesOf<isUncomfortable>(&Times::percentOfSamples));
  to.add({"discomfort_distance_avg", "Mean distance when uncomfortably close", "m",
          Category::Social, Better::Higher, needs,
          "mean of the smallest gap over the samples with it < discomfort_distance", "CrowdNav"},
         figuresOf<uncomfortableGap>(&Figures::mean, "nobody came that close"));
  addTimesAndSpeeds(to);
}

}  // namespace metrics
