#include <algorithm>
#include <cmath>

#include "metrics/Motion.h"
#include "metrics/SeriesMetric.h"

namespace metrics {

namespace {

constexpr double kWideHalfAngle = base::kPi / 3.0;  // half of what people see

/// The target lies within `halfAngle` of where the viewer looks.
bool isInCone(const Body& viewer, const Body& target, double halfAngle) {
  const Vec2 towards = target.position - viewer.position;
  return std::fabs(base::wrapToPi(std::atan2(towards.y(), towards.x()) - viewer.heading)) <=
         halfAngle;
}

using Cone = bool (*)(const Robot& robot, const Person& person, double halfAngle);

bool robotFaces(const Robot& robot, const Person& person, double halfAngle) {
  return isInCone(robot, person, halfAngle);
}
bool personSees(const Robot& robot, const Person& person, double halfAngle) {
  return isInCone(person, robot, halfAngle);
}

bool anyInCone(const Sample& sample, Cone cone, double halfAngle) {
  return std::any_of(sample.people.begin(), sample.people.end(),
                     [&](const Person& person) { return cone(sample.robot, person, halfAngle); });
}

SampleTerm narrow(Cone cone) {
  return [cone](const Sample& sample, const MetricParameters& parameters) {
    return anyInCone(sample, cone, parameters.facingHalfAngle) ? 1.0 : 0.0;
  };
}

SampleTerm wide(Cone cone) {
  return [cone](const Sample& sample, const MetricParameters& /*parameters*/) {
    return anyInCone(sample, cone, kWideHalfAngle) ? 1.0 : 0.0;
  };
}

MetricValue timeOf(const std::vector<double>& inside, const Recording& recording,
                   const MetricParameters& /*parameters*/) {
  return numberValue(timeWhere(recording, [&](std::size_t i) { return inside[i] > 0.0; }));
}

}  // namespace

void addFacing(MetricRegistry& to) {
  const Needs needs{true, true};
  const Category social = Category::Social;
  addSeriesMetric(
      to,
      {"time_facing_people", "Time heading at people", "s", social, Better::Lower, needs,
       "sum of dt_i with a person within facing_half_angle of the robot's heading", "Arena",
       "[0, T]", Kind::Number, 0, ""},
      narrow(robotFaces), timeOf);
  addSeriesMetric(to,
                  {"time_seen_by_people", "Time looked at", "s", social, Better::Neutral, needs,
                   "sum of dt_i with the robot within facing_half_angle of a person's heading",
                   "Arena", "[0, T]", Kind::Number, 0, ""},
                  narrow(personSees), timeOf);
  addSeriesMetric(to,
                  {"time_facing_people_60", "Time heading towards people", "s", social,
                   Better::Lower, needs, "the same within 60 degrees to each side",
                   "Arena, wider cone", "[0, T]", Kind::Number, 0, ""},
                  wide(robotFaces), timeOf);
  addSeriesMetric(to,
                  {"time_seen_by_people_60", "Time in somebody's view", "s", social,
                   Better::Neutral, needs, "the same within 60 degrees to each side",
                   "Arena, wider cone", "[0, T]", Kind::Number, 0, ""},
                  wide(personSees), timeOf);
}

}  // namespace metrics
