#include <cmath>

#include "metrics/TermSums.h"

namespace metrics {

namespace {

constexpr double kWideHalfAngle = base::kPi / 3.0;  // half of what people see

/// Angle between where the viewer looks and the target, not below 0.
double angleTo(const Body& viewer, const Body& target) {
  const Vec2 towards = target.position - viewer.position;
  return std::fabs(base::wrapToPi(std::atan2(towards.y(), towards.x()) - viewer.heading));
}

/// Smallest angle at which the robot heads at somebody: of the one with the largest cosine.
double robotFaces(const Instant& at) {
  const Robot& robot = at.now.robot;
  const Vec2 ahead(std::cos(robot.heading), std::sin(robot.heading));
  const Person* faced = nullptr;
  double best = -2.0;
  for (const Person& person : at.now.people) {
    const double separation = distance(robot, person);
    const double along = ahead.dot(person.position - robot.position);
    const double cosine = separation > 0.0 ? along / separation : 1.0;
    if (cosine > best) {
      best = cosine;
      faced = &person;
    }
  }
  return faced != nullptr ? angleTo(robot, *faced) : kNaN;
}

/// Smallest angle at which somebody looks at the robot.
double personSees(const Instant& at) {
  double smallest = kNaN;
  for (const Person& person : at.now.people) {
    smallest = std::fmin(smallest, person.pair.viewAngle);
  }
  return smallest;
}

template <Term kAngle>
bool isNarrow(const Instant& at) {
  return at.term(kAngle) <= at.parameters.facingHalfAngle;
}

template <Term kAngle>
bool isWide(const Instant& at) {
  return at.term(kAngle) <= kWideHalfAngle;
}

/// Times begin and end on samples: the rate bound is 0.05.
constexpr char kFacingMetrics[] = R"(
= Social Behavior|lower|robot, people|Arena|0.05
time_facing_people|Time heading at people|s|[0, T]|time with |wrap(angle of C - psi)| <= facing_half_angle for the person for whom it is smallest
= Social Behavior|neutral|robot, people|Arena|0.05
time_seen_by_people|Time looked at|s|[0, T]|time with the angle between a person's heading and p - q (0 if d = 0) <= facing_half_angle for some
  person; walls hide no person
= Social Behavior|lower|robot, people|Arena, wider cone|0.05
time_facing_people_60|Time heading towards people|s|[0, T]|as time_facing_people with 60 degrees (pi/3)
= Social Behavior|neutral|robot, people|Arena, wider cone|0.05
time_seen_by_people_60|Time in a person's view|s|[0, T]|as time_seen_by_people with 60 degrees (pi/3)
)";

}  // namespace

void addFacing(MetricRegistry& to) {
  to.add(kFacingMetrics, {{"time_facing_people", timesOf<isNarrow<robotFaces>>(&Times::time)},
                          {"time_seen_by_people", timesOf<isNarrow<personSees>>(&Times::time)},
                          {"time_facing_people_60", timesOf<isWide<robotFaces>>(&Times::time)},
                          {"time_seen_by_people_60", timesOf<isWide<personSees>>(&Times::time)}});
}

}  // namespace metrics
