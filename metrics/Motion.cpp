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
