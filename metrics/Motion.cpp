#include "metrics/Motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace metrics {

bool isInGoalRegion(const RunContext& context, const Vec2& position,
                    const MetricParameters& parameters) {
  return std::any_of(context.goals.begin(), context.goals.end(), [&](const Goal& goal) {
    return lengthOf(position - goal.position) - goal.radius < parameters.goalTolerance;
  });
}

bool isCompleted(const Instant& last) {
  return isInGoalRegion(last.context, last.now.robot.position, last.parameters);
}

double distanceToGoals(const RunContext& context, const Vec2& position) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Goal& goal : context.goals) {
    nearest = std::min(nearest, lengthOf(position - goal.position));
  }
  return nearest;
}

std::vector<Vec2> shortestPath(const RunContext& context, const Vec2& from, const Vec2& to) {
  if (context.routes) {
    return context.routes->shortest(from, to);
  }
  return {from, to};
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

void SpeedChanges::add(const Instant& at) {
  ++count_;
  if (at.before == nullptr) {
    return;
  }
  const double formerInterval = interval_;
  const double former = acceleration_;
  const double change = at.now.robot.speed - at.before->robot.speed;
  interval_ = at.step();
  acceleration_ = interval_ > 0.0 ? change / interval_ : 0.0;
  jerk_.reset();
  if (isInner() && formerInterval > 0.0 && interval_ > 0.0) {
    const double span = at.now.time - timeBefore_;
    jerk_ = (acceleration_ - former) / (span / 2.0);
  }
  timeBefore_ = at.before->time;
}

void ObstacleContacts::add(const Robot& robot) {
  const std::optional<double>& nearest = robot.obstacleDistance;
  const bool touches = nearest && *nearest - robot.radius <= 0.0;
  count_ += touches && !touched_ ? 1 : 0;
  touched_ = touches;
}

}  // namespace metrics
