#include "metrics/RobotMotion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim2d/trace/ContactMarks.h"

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
  if (!last.usesHunavProfile() && (last.arrival || last.context.eventsReportArrivals)) {
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

void ArrivalTime::add(const Instant& at) {
  if (!isInGoalRegion(at.context, at.now.robot.position, at.parameters)) {
    since_.reset();
  } else if (!since_) {
    since_ = at.elapsed();
  }
}

std::optional<double> ArrivalTime::time(const Instant& last) const {
  if (!isCompleted(last)) {
    return std::nullopt;
  }
  return last.arrival ? std::max(*last.arrival - last.begin, 0.0) : since_;
}

void RobotPath::add(const Instant& at) {
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

bool isWithin(const Robot& robot, const Pedestrian& person, double limit) {
  const double reach = limit + robot.radius + person.radius + 1e-6;
  return (robot.position - person.position).squaredNorm() <= reach * reach &&
         gap(robot, person) < limit;
}

/// Uses the velocities before the sample, as the contact may already have stopped the bodies. For a
/// person who was not present before, both velocities are those at the sample, so that they belong
/// to the same time.
void Contacts::addContactStart(const Instant& at, const Pedestrian& person, ContactCauses& to) {
  const Robot& robot = at.now.robot;
  const Pedestrian* before = at.before != nullptr ? findPerson(*at.before, person.id) : nullptr;
  const bool wasThere = before != nullptr && !person.isNew;
  const sim2d::ContactInitiator culprit =
      sim2d::contactInitiator(robot.position, wasThere ? at.before->robot.velocity : robot.velocity,
                              person.position, wasThere ? before->velocity : person.velocity);
  to.robot += culprit != sim2d::ContactInitiator::Second ? 1.0 : 0.0;
  to.person += culprit != sim2d::ContactInitiator::First ? 1.0 : 0.0;
}

void Contacts::add(const Instant& at) {
  ContactCauses culprits;
  touchingNow_.clear();
  begun_.clear();
  for (const Pedestrian& person : at.now.people) {
    if (!isWithin(at.now.robot, person, limit_)) {
      continue;
    }
    touchingNow_.push_back(person.id);
    if (std::find(touching_.begin(), touching_.end(), person.id) == touching_.end()) {
      addContactStart(at, person, culprits);
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

namespace {

/// Integral from 0 of P(x / h), where P is the Legendre polynomial of degree two.
double ofParabola(double x, double h) {
  return 0.5 * (x * x * x / (h * h) - x);
}

/// The same for x P(x / h).
double ofSlope(double x, double h) {
  return 0.5 * (0.75 * x * x * x * x / (h * h) - 0.5 * x * x);
}

}  // namespace

bool Jerk::isCoarse() const {
  const double time = points_[next_].time;
  return time - points_[next_ - 1].time > half_ + kTimeSlack ||
         points_[next_ + 1].time - time > half_ + kTimeSlack;
}

double Jerk::secondDifference() const {
  const Point& before = points_[next_ - 1];
  const Point& at = points_[next_];
  const Point& after = points_[next_ + 1];
  if (!(at.time > before.time) || !(after.time > at.time)) {
    return kNaN;
  }
  const double former = (at.speed - before.speed) / (at.time - before.time);
  const double latter = (after.speed - at.speed) / (after.time - at.time);
  return (latter - former) / ((after.time - before.time) / 2.0);
}

/// Integral of (speed - speed at the centre) P between two samples, within the window.
double Jerk::integral(const Point& from, const Point& to, const Point& centre) const {
  const double a = std::max(from.time - centre.time, -half_);
  const double b = std::min(to.time - centre.time, half_);
  if (!(b > a)) {
    return 0.0;
  }
  const double slope = (to.speed - from.speed) / (to.time - from.time);
  const double atCentre =
      from.speed - centre.speed - slope * (from.time - centre.time);  // of the line
  return atCentre * (ofParabola(b, half_) - ofParabola(a, half_)) +
         slope * (ofSlope(b, half_) - ofSlope(a, half_));
}

double Jerk::windowed(const Point& centre) const {
  if (centre.time - half_ < *first_ - kTimeSlack) {
    return kNaN;
  }
  double sum = 0.0;
  for (std::size_t k = 1; k < points_.size(); ++k) {
    sum += integral(points_[k - 1], points_[k], centre);
  }
  return 7.5 * sum / (half_ * half_ * half_);
}

void Jerk::add(double time, double speed, const std::function<void(double)>& take,
               const std::function<void(double)>& between) {
  first_ = first_.value_or(time);
  points_.push_back({time, speed});
  while (next_ + 1 < points_.size()) {
    const bool coarse = isCoarse();
    if (!coarse && time < points_[next_].time + half_ - kTimeSlack) {
      return;
    }
    const Point& at = points_[next_];
    const Point& before = points_[next_ - 1];
    if (!coarse) {
      between(windowed({0.5 * (before.time + at.time), 0.5 * (before.speed + at.speed)}));
    }
    take(coarse ? secondDifference() : windowed(at));
    ++next_;
    while (next_ > 1 && points_[1].time <= points_[next_ - 1].time - half_) {
      points_.pop_front();
      --next_;
    }
  }
}

}  // namespace metrics
