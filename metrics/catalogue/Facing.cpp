#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/TermSums.h"

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

bool isNarrow(double angle, const MetricParameters& parameters) {
  return angle <= parameters.facingHalfAngle;
}

bool isWide(double angle, const MetricParameters& /*parameters*/) {
  return angle <= kWideHalfAngle;
}

template <Term kTerm, TermTest kTest>
Stream timeWithin() {
  return streamOf<WhereTerm<kTerm, kTest>>(&WhereTerm<kTerm, kTest>::time);
}

}  // namespace

void addFacing(MetricRegistry& to) {
  const Needs needs{true, true};
  const Category social = Category::Social;
  to.add({"time_facing_people", "Time heading at people", "s", social, Better::Lower, needs,
          "sum of dt_i with a person within facing_half_angle of the robot's heading", "Arena",
          "[0, T]"},
         timeWithin<robotFaces, isNarrow>());
  to.add({"time_seen_by_people", "Time looked at", "s", social, Better::Neutral, needs,
          "sum of dt_i with the robot within facing_half_angle of a person's heading", "Arena",
          "[0, T]"},
         timeWithin<personSees, isNarrow>());
  to.add({"time_facing_people_60", "Time heading towards people", "s", social, Better::Lower, needs,
          "the same within 60 degrees to each side", "Arena, wider cone", "[0, T]"},
         timeWithin<robotFaces, isWide>());
  to.add({"time_seen_by_people_60", "Time in somebody's view", "s", social, Better::Neutral, needs,
          "the same within 60 degrees to each side", "Arena, wider cone", "[0, T]"},
         timeWithin<personSees, isWide>());
  for (const char* key : {"time_facing_people", "time_seen_by_people", "time_facing_people_60",
                          "time_seen_by_people_60"}) {
    to.setRateBound(key, 0.05);  // begins and ends on samples
  }
}

}  // namespace metrics
