#include "metrics/Motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace metrics {

double pathLength(const Recording& recording) {
  double length = 0.0;
  for (std::size_t i = 1; i < recording.size(); ++i) {
    length += distance(recording.samples[i].robot, recording.samples[i - 1].robot);
  }
  return length;
}

std::vector<double> headingChanges(const Recording& recording) {
  std::vector<double> changes(recording.size(), 0.0);
  for (std::size_t i = 1; i < recording.size(); ++i) {
    changes[i] = std::fabs(base::angleDiff(recording.samples[i].robot.heading,
                                           recording.samples[i - 1].robot.heading));
  }
  return changes;
}

std::vector<double> accelerations(const Recording& recording) {
  std::vector<double> values;
  for (std::size_t i = 0; i + 1 < recording.size(); ++i) {
    const double dt = recording.interval(i);
    const double change = recording.samples[i + 1].robot.speed - recording.samples[i].robot.speed;
    values.push_back(dt > 0.0 ? change / dt : 0.0);
  }
  return values;
}

std::vector<std::optional<double>> jerks(const Recording& recording) {
  const std::vector<double> acceleration = accelerations(recording);
  std::vector<std::optional<double>> values;
  for (std::size_t i = 1; i + 1 < recording.size(); ++i) {
    if (recording.interval(i - 1) > 0.0 && recording.interval(i) > 0.0) {
      const double span = recording.samples[i + 1].time - recording.samples[i - 1].time;
      values.emplace_back((acceleration[i] - acceleration[i - 1]) / (span / 2.0));
    } else {
      values.emplace_back();
    }
  }
  return values;
}

bool isInGoalRegion(const Recording& recording, std::size_t sample,
                    const MetricParameters& parameters) {
  const Vec2& position = recording.samples[sample].robot.position;
  return std::any_of(recording.goals.begin(), recording.goals.end(), [&](const Goal& goal) {
    return lengthOf(position - goal.position) - goal.radius < parameters.goalTolerance;
  });
}

bool isCompleted(const Recording& recording, const MetricParameters& parameters) {
  return isInGoalRegion(recording, recording.size() - 1, parameters);
}

double distanceToGoals(const Recording& recording, std::size_t sample) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Goal& goal : recording.goals) {
    nearest = std::min(nearest, lengthOf(recording.samples[sample].robot.position - goal.position));
  }
  return nearest;
}

namespace {

constexpr double kEqualSpeeds = 1e-6;  // [m/s]

/// The velocities before the sample, as the contact may have stopped the bodies already.
void countContact(const Recording& recording, std::size_t i, const Person& person,
                  ContactEvents& events) {
  const Robot& robot = recording.samples[i].robot;
  const Sample* before = i > 0 ? &recording.samples[i - 1] : nullptr;
  const Person* personBefore = before != nullptr ? findPerson(*before, person.id) : nullptr;
  const Vec2 between = person.position - robot.position;
  const double separation = lengthOf(between);
  const Vec2 normal = separation > 0.0 ? Vec2(between / separation) : Vec2(0.0, 0.0);
  const Vec2& robotVelocity = before != nullptr ? before->robot.velocity : robot.velocity;
  const Vec2& personVelocity = personBefore != nullptr ? personBefore->velocity : person.velocity;
  const double byRobot = robotVelocity.dot(normal);
  const double byPerson = -personVelocity.dot(normal);
  if (byRobot > byPerson - kEqualSpeeds) {
    events.robotOnPerson[i] += 1.0;
  }
  if (byPerson > byRobot - kEqualSpeeds) {
    events.personOnRobot[i] += 1.0;
  }
}

/// gap < limit; the squares settle it for whoever is clearly farther away.
bool isWithin(const Robot& robot, const Person& person, double limit) {
  const double reach = limit + robot.radius + person.radius + 1e-6;
  return (robot.position - person.position).squaredNorm() <= reach * reach &&
         gap(robot, person) < limit;
}

/// Calls `begins(sample, person)` whenever the gap of a pair falls below the limit.
template <class Begins>
void forEachEntry(const Recording& recording, double limit, Begins begins) {
  std::vector<int> touching;
  std::vector<int> touchingNow;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    touchingNow.clear();
    for (const Person& person : recording.samples[i].people) {
      if (!isWithin(recording.samples[i].robot, person, limit)) {
        continue;
      }
      touchingNow.push_back(person.id);
      if (std::find(touching.begin(), touching.end(), person.id) == touching.end()) {
        begins(i, person);
      }
    }
    touching.swap(touchingNow);
  }
}

}  // namespace

ContactEvents contactEvents(const Recording& recording, double limit) {
  ContactEvents events;
  events.robotOnPerson.assign(recording.size(), 0.0);
  events.personOnRobot.assign(recording.size(), 0.0);
  forEachEntry(recording, limit, [&](std::size_t i, const Person& person) {
    countContact(recording, i, person, events);
  });
  return events;
}

double entryCount(const Recording& recording, double limit) {
  double count = 0.0;
  forEachEntry(recording, limit,
               [&count](std::size_t /*i*/, const Person& /*person*/) { count += 1.0; });
  return count;
}

int obstacleContacts(const Recording& recording) {
  int count = 0;
  bool touched = false;
  for (const Sample& sample : recording.samples) {
    const std::optional<double>& nearest = sample.robot.obstacleDistance;
    const bool touches = nearest && *nearest - sample.robot.radius <= 0.0;
    count += touches && !touched ? 1 : 0;
    touched = touches;
  }
  return count;
}

std::vector<Vec2> shortestPath(const Recording& recording, const Vec2& from, const Vec2& to) {
  if (recording.routes) {
    return recording.routes->shortest(from, to);
  }
  return {from, to};
}

}  // namespace metrics
