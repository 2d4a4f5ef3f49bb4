#include <cmath>

#include "metrics/TermStatistics.h"

namespace metrics {

namespace {

constexpr double kWideHalfAngle = base::kPi / 3.0;  // half of the visual field of people

/// Angle between the viewer's heading and the target, >= 0; 0 for a target at the same place.
double angleTo(const Body& viewer, const Body& target) {
  const Vec2 towards = target.position - viewer.position;
  if (towards.isZero(0.0)) {
    return 0.0;
  }
  return std::fabs(base::wrapToPi(std::atan2(towards.y(), towards.x()) - viewer.heading));
}

/// Smallest angle between the robot's heading and a person, namely the one with the largest cosine.
double robotFaces(const Instant& at) {
  const Robot& robot = at.now.robot;
  const Vec2 ahead(std::cos(robot.heading), std::sin(robot.heading));
  const Pedestrian* faced = nullptr;
  double best = -2.0;
  for (const Pedestrian& person : at.now.people) {
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

/// Smallest angle between a person's heading and the robot.
double personSees(const Instant& at) {
  double smallest = kNaN;
  for (const Pedestrian& person : at.now.people) {
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

/// The times start and end on samples: the rate bound is 0.05.
constexpr char kFacingMetrics[] = R"(
= Social Behavior|lower|robot, people|Arena|0.05
time_facing_people|Time facing people|s|[0, T]|time with |wrap(angle of C - psi)| (0 if d = 0) <= facing_half_angle for the person for whom it is smallest
= Social Behavior|neutral|robot, people|Arena|0.05
time_seen_by_people|Time seen by people|s|[0, T]|time with the angle between a person's heading and p - q (0 if d = 0) <= facing_half_angle for some person;
  walls hide no person
= Social Behavior|lower|robot, people|Arena, wider cone|0.05
time_facing_people_60|Time facing people, 60 degrees|s|[0, T]|as time_facing_people, with pi/3 (60 degrees to each side) instead of facing_half_angle
= Social Behavior|neutral|robot, people|Arena, wider cone|0.05
time_seen_by_people_60|Time seen by people, 60 degrees|s|[0, T]|as time_seen_by_people, with pi/3 (60 degrees to each side) instead of
  facing_half_angle
)";

}  // namespace

void addFacing(MetricRegistry& to) {
  to.add(kFacingMetrics,
         {{"time_facing_people", conditionTimeOf<isNarrow<robotFaces>>(&ConditionTime::time)},
          {"time_seen_by_people", conditionTimeOf<isNarrow<personSees>>(&ConditionTime::time)},
          {"time_facing_people_60", conditionTimeOf<isWide<robotFaces>>(&ConditionTime::time)},
          {"time_seen_by_people_60", conditionTimeOf<isWide<personSees>>(&ConditionTime::time)}});
}

}  // namespace metrics
