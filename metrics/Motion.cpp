#include "metrics/Motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace metrics {

bool isInGoalRegion(const RunContext& context, const Vec2& position,
                    const MetricParameters& parameters) {
  return std::any_of(context.goals.begin(), context.goals.end(), [&](const sim2d::TraceGoal& goal) {
    return lengthOf(position - goal.position) - goal.radius < parameters.goalTolerance;
  });
}

bool isStanding(const Robot& robot, const MetricParameters& parameters) {
  return std::fabs(robot.speed) < parameters.stopLinearSpeed &&
         std::fabs(robot.omega) < parameters.stopAngularSpeed;
}

bool isCompleted(const Instant& last) {
  return isInGoalRegion(last.context, last.now.robot.position, last.parameters);
}

double distanceToGoals(const RunContext& context, const Vec2& position) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const sim2d::TraceGoal& goal : context.goals) {
    nearest = std::min(nearest, lengthOf(position - goal.position));
  }
  return nearest;
}

void RobotWay::add(const Instant& at) {
  const Robot& robot = at.now.robot;
  if (at.before == nullptr) {
    start_ = robot.position;
    startHeading_ = robot.heading;
    turns_.add(at, 0.0);
    return;
  }
  length_ += distance(robot, at.before->robot);
  turns_.add(at, std::fabs(base::angleDiff(robot.heading, at.before->robot.heading)));
}

bool isWithin(const Robot& robot, const Person& person, double limit) {
  const double reach = limit + robot.radius + person.radius + 1e-6;
  return (robot.position - person.position).squaredNorm() <= reach * reach &&
         gap(robot, person) < limit;
}

/// The velocities before the sample, as the contact may have stopped the bodies already.
void Contacts::addEntry(const Instant& at, const Person& person, Culprits& to) {
  constexpr double kEqualSpeeds = 1e-6;  // [m/s]
  const Robot& robot = at.now.robot;
  const Person* personBefore = at.before != nullptr ? findPerson(*at.before, person.id) : nullptr;
  const Vec2 between = person.position - robot.position;
  const double separation = lengthOf(between);
  const Vec2 normal = separation > 0.0 ? Vec2(between / separation) : Vec2(0.0, 0.0);
  const Vec2& robotVelocity = at.before != nullptr ? at.before->robot.velocity : robot.velocity;
  const Vec2& personVelocity = personBefore != nullptr ? personBefore->velocity : person.velocity;
  const double byRobot = robotVelocity.dot(normal);
  const double byPerson = -personVelocity.dot(normal);
  to.robot += byRobot > byPerson - kEqualSpeeds ? 1.0 : 0.0;
  to.person += byPerson > byRobot - kEqualSpeeds ? 1.0 : 0.0;
}

void Contacts::add(const Instant& at) {
  Culprits culprits;
  touchingNow_.clear();
  for (const Person& person : at.now.people) {
    if (!isWithin(at.now.robot, person, limit_)) {
      continue;
    }
    touchingNow_.push_back(person.id);
    if (std::find(touching_.begin(), touching_.end(), person.id) == touching_.end()) {
      addEntry(at, person, culprits);
      count_ += 1.0;
    }
  }
  byRobot_.add(at, culprits.robot);
  byPerson_.add(at, culprits.person);
  touching_.swap(touchingNow_);
}

}  // namespace metrics
