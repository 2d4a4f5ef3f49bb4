#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/Motion.h"
#include "metrics/SeriesMetric.h"

namespace metrics {

namespace {

constexpr double kWideHalfAngle = base::kPi / 3.0;  // half of what people see

/// Angle between where the viewer looks and the target, not below 0.
double angleTo(const Body& viewer, const Body& target) {
  const Vec2 towards = target.position - viewer.position;
  return std::fabs(base::wrapToPi(std::atan2(towards.y(), towards.x()) - viewer.heading));
}

constexpr double kNobody = std::numeric_limits<double>::infinity();

/// Smallest angle at which the robot heads at somebody: of the one with the largest cosine.
double robotFaces(const Sample& sample, const MetricParameters& /*parameters*/) {
  const Vec2 ahead(std::cos(sample.robot.heading), std::sin(sample.robot.heading));
  const Person* faced = nullptr;
  double best = -2.0;
  for (const Person& person : sample.people) {
    const double separation = distance(sample.robot, person);
    const double along = ahead.dot(person.position - sample.robot.position);
    const double cosine = separation > 0.0 ? along / separation : 1.0;
    if (cosine > best) {
      best = cosine;
      faced = &person;
    }
  }
  return faced != nullptr ? angleTo(sample.robot, *faced) : kNobody;
}

/// Smallest angle at which somebody looks at the robot.
double personSees(const Sample& sample, const MetricParameters& /*parameters*/) {
  double smallest = kNobody;
  for (const Person& person : sample.people) {
    smallest = std::min(smallest, person.pair.viewAngle);
  }
  return smallest;
}

MetricValue narrow(const std::vector<double>& angles, const Recording& recording,
                   const MetricParameters& parameters) {
  return numberValue(
      timeWhere(recording, [&](std::size_t i) { return angles[i] <= parameters.facingHalfAngle; }));
}

MetricValue wide(const std::vector<double>& angles, const Recording& recording,
                 const MetricParameters& /*parameters*/) {
  return numberValue(
      timeWhere(recording, [&](std::size_t i) { return angles[i] <= kWideHalfAngle; }));
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
      robotFaces, narrow);
  addSeriesMetric(to,
                  {"time_seen_by_people", "Time looked at", "s", social, Better::Neutral, needs,
                   "sum of dt_i with the robot within facing_half_angle of a person's heading",
                   "Arena", "[0, T]", Kind::Number, 0, ""},
                  personSees, narrow);
  addSeriesMetric(to,
                  {"time_facing_people_60", "Time heading towards people", "s", social,
                   Better::Lower, needs, "the same within 60 degrees to each side",
                   "Arena, wider cone", "[0, T]", Kind::Number, 0, ""},
                  robotFaces, wide);
  addSeriesMetric(to,
                  {"time_seen_by_people_60", "Time in somebody's view", "s", social,
                   Better::Neutral, needs, "the same within 60 degrees to each side",
                   "Arena, wider cone", "[0, T]", Kind::Number, 0, ""},
                  personSees, wide);
  for (const char* key : {"time_facing_people", "time_seen_by_people", "time_facing_people_60",
                          "time_seen_by_people_60"}) {
    to.setRateBound(key, 0.05);  // begins and ends on samples
  }
}

}  // namespace metrics
