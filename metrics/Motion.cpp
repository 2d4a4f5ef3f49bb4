#include "metrics/Motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim2d/trace/Culprit.h"

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
  if (!last.isOriginal() && (last.arrival || last.context.eventsTellArrivals)) {
    return last.arrival.has_value() && !last.context.goals.empty();
  }
  return isInGoalRegion(last.context, last.now.robot.position, last.parameters);
}

double distanceToGoals(const RunContext& context, const Vec2& position) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const sim2d::TraceGoal& goal : context.goals) {
    nearest = std::min(nearest, lengthOf(position - goal.position));
  }
  return nearest;
}

void Arriving::add(const Instant& at) {
  if (!isInGoalRegion(at.context, at.now.robot.position, at.parameters)) {
    since_.reset();
  } else if (!since_) {
    since_ = at.elapsed();
  }
}

std::optional<double> Arriving::time(const Instant& last) const {
  if (!isCompleted(last)) {
    return std::nullopt;
  }
  return last.arrival ? std::max(*last.arrival - last.begin, 0.0) : since_;
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

/// The velocities before the sample, as the contact may have stopped the bodies already. For a
/// person who was not present before, the velocities of both at the sample: never velocities of
/// different times.
void Contacts::addEntry(const Instant& at, const Person& person, Culprits& to) {
  const Robot& robot = at.now.robot;
  const Person* before = at.before != nullptr ? findPerson(*at.before, person.id) : nullptr;
  const bool wasThere = before != nullptr && !person.isNew;
  const sim2d::Culprit culprit =
      sim2d::culpritOf(robot.position, wasThere ? at.before->robot.velocity : robot.velocity,
                       person.position, wasThere ? before->velocity : person.velocity);
  to.robot += culprit != sim2d::Culprit::Second ? 1.0 : 0.0;
  to.person += culprit != sim2d::Culprit::First ? 1.0 : 0.0;
}

void Contacts::add(const Instant& at) {
  Culprits culprits;
  touchingNow_.clear();
  begun_.clear();
  for (const Person& person : at.now.people) {
    if (!isWithin(at.now.robot, person, limit_)) {
      continue;
    }
    touchingNow_.push_back(person.id);
    if (std::find(touching_.begin(), touching_.end(), person.id) == touching_.end()) {
      addEntry(at, person, culprits);
      begun_.push_back(person.id);
    }
  }
  count_ += static_cast<double>(begun_.size());
  byRobot_.add(at, culprits.robot);
  byPerson_.add(at, culprits.person);
  touching_.swap(touchingNow_);
}

void ObstacleContacts::add(const Instant& at) {
  const Robot& robot = at.now.robot;
  const bool touches = robot.obstacleDistance && *robot.obstacleDistance - robot.radius <= 0.0;
  hasBegun_ = touches && !touches_;
  touches_ = touches;
  count_ += hasBegun_ ? 1.0 : 0.0;
}

}  // namespace metrics
