#include "metrics/Samples.h"

#include <algorithm>
#include <cmath>

namespace metrics {

double lengthOf(const Vec2& vector) {
  return std::hypot(vector.x(), vector.y());
}

double distance(const Body& a, const Body& b) {
  return lengthOf(a.position - b.position);
}

double distance(const Robot& robot, const Person& person) {
  return person.pair.isKnown ? person.pair.distance : lengthOf(robot.position - person.position);
}

double gap(const Robot& robot, const Person& person) {
  return distance(robot, person) - robot.radius - person.radius;
}

std::optional<double> closestGap(const Sample& sample) {
  std::optional<double> closest;
  for (const Person& person : sample.people) {
    const double gapToPerson = std::max(gap(sample.robot, person), 0.0);
    if (!closest || gapToPerson < *closest) {
      closest = gapToPerson;
    }
  }
  return closest;
}

const Person* findPerson(const Sample& sample, int id) {
  for (const Person& person : sample.people) {
    if (person.id == id) {
      return &person;
    }
  }
  return nullptr;
}

SampledRun withBehavior(const SampledRun& recording, int behavior) {
  SampledRun part = recording;
  for (Sample& sample : part.samples) {
    sample.people.erase(
        std::remove_if(sample.people.begin(), sample.people.end(),
                       [behavior](const Person& person) { return person.behavior != behavior; }),
        sample.people.end());
  }
  return part;
}

}  // namespace metrics
