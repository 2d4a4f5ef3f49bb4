#include <algorithm>
#include <cmath>

#include "metrics/TermStatistics.h"

/// Distances to people.
namespace metrics {

namespace {

MetricValue amongPeople(double value, const Instant& last) {
  const char* why = last.usesHunavProfile() ? "ValueError: no people in the recording" : kNoPeople;
  return std::isnan(value) ? undefinedValue(why) : value;
}

/// The evaluator's series excludes samples without people.
MetricValue averageDistance(const TermStatistics& closest, const Instant& last) {
  if (!last.usesHunavProfile()) {
    return closest.meanWithSeries();
  }
  std::vector<double> series = closest.series();
  series.erase(std::remove_if(series.begin(), series.end(),
                              [](double distance) { return std::isnan(distance); }),
               series.end());
  return withSeries(closest.sum() / static_cast<double>(last.count()), std::move(series));
}

MetricValue minimumDistance(const TermStatistics& closest, const Instant& last) {
  return amongPeople(closest.least(), last);
}

double farthestGap(const Instant& at) {
  double farthest = kNaN;
  for (const Pedestrian& person : at.now.people) {
    farthest = std::fmax(farthest, gap(at.now.robot, person));
  }
  return farthest;
}

MetricValue maximumDistance(const TermStatistics& farthest, const Instant& last) {
  const double largest = farthest.largest();
  return amongPeople(last.usesHunavProfile() ? largest : std::max(largest, 0.0), last);
}

MetricValue minimumTimeToCollision(const TermStatistics& times) {
  return times.count() > 0.0 ? times.least() : infiniteValue("never on a collision course");
}

bool complies(const Instant& at) {
  return !(at.term(smallestGapTerm) < at.parameters.complianceDistance);
}

bool isUncomfortable(const Instant& at) {
  return at.term(smallestGapTerm) < at.parameters.discomfortDistance;
}

double uncomfortableGap(const Instant& at) {
  return isUncomfortable(at) ? at.term(smallestGapTerm) : kNaN;
}

/// Whether a person's centre lies within the personal radius.
bool isInPersonalSpace(const Instant& at) {
  const std::vector<Pedestrian>& people = at.now.people;
  return std::any_of(people.begin(), people.end(), [&at](const Pedestrian& person) {
    return distance(at.now.robot, person) <= at.parameters.personalRadius;
  });
}

double speedInPersonalSpace(const Instant& at) {
  return isInPersonalSpace(at) ? lengthOf(at.now.robot.velocity) : kNaN;
}

double speedInIntimateSpace(const Instant& at) {
  return at.term(smallestGapTerm) < at.parameters.intimateDistance ? lengthOf(at.now.robot.velocity)
                                                                   : kNaN;
}

double meanOrZero(const TermStatistics& speeds) {
  return std::fmax(speeds.mean(), 0.0);
}

double largestOrZero(const TermStatistics& speeds) {
  return std::fmax(speeds.largest(), 0.0);
}

constexpr char kPersonalSpaceMetrics[] = R"(
= Social Behavior|higher|robot, people|Perez-Higueras, Caballero, Merino, IJSR 2018
4 avg_distance_to_closest_person|Mean distance to the closest person|m|[0, inf)|mean of c_i over the samples with people; surfaces, not centres
5 minimum_distance_to_people|Smallest distance to people|m|[0, inf)|min over i of c_i; surfaces, not centres
= Navigation Performance|neutral|robot, people|Perez-Higueras, Caballero, Merino, IJSR 2018
6 maximum_distance_to_people|Largest distance to people|m|[0, inf)|max over i, a of max(gap, 0); surfaces, not centres
= Safety & Collisions|higher|robot, people|Francis et al. 2025; SocNavBench; SocNavGym
min_time_to_collision|Smallest time to collision|s|[0, inf]|min over i, a of ttc, infinite if never on a collision course
= Social Behavior|higher|robot, people|Francis et al. 2025; SocNavGym
space_compliance|Personal space compliance|%|[0, 100]|share of samples with c_i >= compliance_distance or no person present
= Social Behavior|lower|robot, people|CrowdNav
discomfort_frequency|Discomfort frequency|%|[0, 100]|share of samples with c_i < discomfort_distance
= Social Behavior|higher|robot, people|CrowdNav
discomfort_distance_avg|Mean distance during discomfort|m|[0, inf)|mean of c_i over the samples with c_i < discomfort_distance; undefined if there is none
= Social Behavior|lower|robot, people|Arena
time_in_personal_space|Time in personal space|s|[0, T]|time with d <= personal_radius for some person; centres
avg_speed_in_personal_space|Mean speed in personal space|m/s|[0, inf)|mean of s_i over the samples with d <= personal_radius for some person, 0 if
  there is none; centres
max_speed_in_intimate_space|Largest speed in intimate space|m/s|[0, inf)|max of s_i over the samples with c_i < intimate_distance, 0 if there is none
)";

}  // namespace

void addPersonalSpace(MetricRegistry& to) {
  to.add(
      kPersonalSpaceMetrics,
      {{"avg_distance_to_closest_person",
        seriesStatisticsOf<smallestGapTerm>(averageDistance, kNoPeople)},
       {"minimum_distance_to_people", statisticsOf<smallestGapTerm>(minimumDistance)},
       {"maximum_distance_to_people", statisticsOf<farthestGap>(maximumDistance)},
       {"min_time_to_collision", statisticsOf<timeToCollisionTerm>(minimumTimeToCollision)},
       {"space_compliance", conditionTimeOf<complies>(&ConditionTime::percentOfSamples)},
       {"discomfort_frequency", conditionTimeOf<isUncomfortable>(&ConditionTime::percentOfSamples)},
       {"discomfort_distance_avg",
        statisticsOf<uncomfortableGap>(&TermStatistics::mean, "no person came that close")},
       {"time_in_personal_space", conditionTimeOf<isInPersonalSpace>(&ConditionTime::time)},
       {"avg_speed_in_personal_space", statisticsOf<speedInPersonalSpace>(meanOrZero)},
       {"max_speed_in_intimate_space", statisticsOf<speedInIntimateSpace>(largestOrZero)}});
}

}  // namespace metrics
