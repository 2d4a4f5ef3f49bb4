#include "metrics/ContactEvents.h"

#include <algorithm>

namespace metrics {

namespace {

constexpr double kEqualSpeeds = 1e-6;  // [m/s]

/// gap < limit; the squares settle it for whoever is clearly farther away.
bool isWithin(const Robot& robot, const Person& person, double limit) {
  const double reach = limit + robot.radius + person.radius + 1e-6;
  return (robot.position - person.position).squaredNorm() <= reach * reach &&
         gap(robot, person) < limit;
}

}  // namespace

/// The velocities before the sample, as the contact may have stopped the bodies already.
void ContactEvents::addEntry(const Sample& now, const Sample* before, const Person& person) {
  const Person* personBefore = before != nullptr ? findPerson(*before, person.id) : nullptr;
  const Vec2 between = person.position - now.robot.position;
  const double separation = lengthOf(between);
  const Vec2 normal = separation > 0.0 ? Vec2(between / separation) : Vec2(0.0, 0.0);
  const Vec2& robotVelocity = before != nullptr ? before->robot.velocity : now.robot.velocity;
  const Vec2& personVelocity = personBefore != nullptr ? personBefore->velocity : person.velocity;
  const double byRobot = robotVelocity.dot(normal);
  const double byPerson = -personVelocity.dot(normal);
  byRobot_.back() += byRobot > byPerson - kEqualSpeeds ? 1.0 : 0.0;
  byPerson_.back() += byPerson > byRobot - kEqualSpeeds ? 1.0 : 0.0;
  count_ += 1.0;
}

void ContactEvents::add(const Recording& recording, std::size_t sample) {
  const Sample& now = recording.samples[sample];
  byRobot_.push_back(0.0);
  byPerson_.push_back(0.0);
  touchingNow_.clear();
  for (const Person& person : now.people) {
    if (!isWithin(now.robot, person, limit_)) {
      continue;
    }
    touchingNow_.push_back(person.id);
    if (std::find(touching_.begin(), touching_.end(), person.id) == touching_.end()) {
      addEntry(now, sample > 0 ? &recording.samples[sample - 1] : nullptr, person);
    }
  }
  touching_.swap(touchingNow_);
}

Stream contactStream(double MetricParameters::*limit, const std::string& name, ContactReader read) {
  return streamOf<ContactEvents>("gaps below " + name, std::move(read),
                                 [limit](const MetricParameters& parameters) {
                                   return std::make_unique<ContactEvents>(parameters.*limit);
                                 });
}

}  // namespace metrics
