#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include <QJsonArray>
#include <QJsonObject>

#include "tests/app/RunFiles.h"

/// Metrics worked out from the files of a run by formulas that are written here once more.
namespace outside {

inline double hypot2(double x, double y) {
  return std::sqrt(x * x + y * y);
}

/// Everything of a run folder that the recomputation needs, read by code of the tests.
struct Run {
  std::vector<Sample> samples;
  std::map<int, double> radius;  // of people, by id [m]
  double robotRadius = 0, goalX = 0, goalY = 0;
  bool hasArrived = false;  // with the last of the samples
  QJsonObject metrics;

  explicit Run(const QString& folder) {
    samples = readTrajectory(folder + QStringLiteral("/trajectory.csv"));
    metrics = metricsOf(folder);
    const QJsonObject header = readJson(folder + QStringLiteral("/trace.json"));
    for (const auto& value : header[QStringLiteral("humans")].toArray()) {
      const QJsonObject human = value.toObject();
      radius[human[QStringLiteral("id")].toInt()] = human[QStringLiteral("radius")].toDouble();
    }
    const QJsonArray robots = header[QStringLiteral("robots")].toArray();
    if (robots.isEmpty()) {
      return;
    }
    const QJsonObject robot = robots[0].toObject();
    robotRadius = robot[QStringLiteral("radius")].toDouble();
    const QJsonArray goals = robot[QStringLiteral("goals")].toArray();
    if (!goals.isEmpty()) {
      const QJsonObject goal = goals[0].toObject();
      goalX = goal[QStringLiteral("x")].toDouble();
      goalY = goal[QStringLiteral("y")].toDouble();
    }
  }

  double gap(const Sample& sample, const Body& person) const {
    return hypot2(sample.robot->x - person.x, sample.robot->y - person.y) - robotRadius -
           radius.at(person.id);
  }
  double closest(const Sample& sample) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Body& person : sample.people) {
      least = std::min(least, std::max(0.0, gap(sample, person)));
    }
    return least;
  }
  double toGoal(const Sample& sample) const {
    return hypot2(sample.robot->x - goalX, sample.robot->y - goalY);
  }
};

inline double distanceToGroups(const Run& run, const Sample& sample) {
  std::map<int, std::vector<Body>> groups;
  for (const Body& person : sample.people) {
    if (person.group != -1) {
      groups[person.group].push_back(person);
    }
  }
  double least = 1e300;
  for (const auto& [id, members] : groups) {
    if (members.size() < 2) {
      continue;
    }
    double x = 0, y = 0;
    for (const Body& member : members) {
      x += member.x + 1.5 * std::cos(member.heading);
      y += member.y + 1.5 * std::sin(member.heading);
    }
    const double n = static_cast<double>(members.size());
    const double distance = hypot2(sample.robot->x - x / n, sample.robot->y - y / n);
    least = std::min(least, std::max(0.0, distance - run.robotRadius));
  }
  return least;
}

/// Keys 1 to 15 by the written formulas of the corrected profile.
inline std::map<QString, double> recompute(const Run& run) {
  std::map<QString, double> value;
  const auto set = [&value](const char* key, double number) {
    value[QString::fromLatin1(key)] = number;
  };
  const std::size_t count = run.samples.size();
  double length = 0, turning = 0, closestSum = 0, least = 1e300, most = 0, nearestGoal = 1e300;
  double withPeople = 0, bands[3] = {0, 0, 0}, groupBands[3] = {0, 0, 0};
  const double edges[4] = {-1.0, 0.45, 1.2, 3.6};
  for (std::size_t i = 0; i < count; ++i) {
    const Sample& sample = run.samples[i];
    const Body& robot = *sample.robot;
    if (i > 0) {
      const Body& before = *run.samples[i - 1].robot;
      length += hypot2(robot.x - before.x, robot.y - before.y);
      turning += std::fabs(turn(robot.heading - before.heading));
    }
    nearestGoal = std::min(nearestGoal, run.toGoal(sample));
    for (const Body& person : sample.people) {
      least = std::min(least, std::max(0.0, run.gap(sample, person)));
      most = std::max(most, run.gap(sample, person));
    }
    if (!sample.people.empty()) {
      const double closest = run.closest(sample);
      closestSum += closest;
      withPeople += 1;
      for (int band = 0; band < 3; ++band) {
        bands[band] += closest >= edges[band] && closest < edges[band + 1] ? 1 : 0;
      }
    }
    const double groupDistance = distanceToGroups(run, sample);
    for (int band = 0; band < 3; ++band) {
      groupBands[band] += groupDistance >= edges[band] && groupDistance < edges[band + 1] ? 1 : 0;
    }
  }
  const double n = static_cast<double>(count);
  if (run.hasArrived) {
    set("time_to_reach_goal", run.samples.back().time - run.samples.front().time);
  }
  set("path_length", length);
  set("cumulative_heading_changes", turning);
  set("avg_distance_to_closest_person", closestSum / withPeople);
  set("minimum_distance_to_people", least);
  set("maximum_distance_to_people", std::max(0.0, most));
  const char* names[3] = {"intimate", "personal", "social"};
  for (int band = 0; band < 3; ++band) {
    set(qPrintable(QString::fromLatin1(names[band]) + QStringLiteral("_space_intrusions")),
        100.0 * bands[band] / n);
    set(qPrintable(QStringLiteral("group_") + QString::fromLatin1(names[band]) +
                   QStringLiteral("_space_intrusions")),
        100.0 * groupBands[band] / n);
  }
  set("completed", run.hasArrived ? 1 : 0);
  set("minimum_distance_to_target", nearestGoal);
  set("final_distance_to_target", run.toGoal(run.samples.back()));
  return value;
}

}  // namespace outside
