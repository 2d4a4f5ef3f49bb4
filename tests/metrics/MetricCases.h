#pragma once

#include <cmath>

#include "metrics/Report.h"

/// Records for tests.
namespace cases {

/// A robot that swerves through people who walk in circles of their own; positions, velocities and
/// headings fit together.
inline sim2d::Frame frameAt(int step, int people, double dt) {
  sim2d::Frame frame;
  frame.step = step;
  frame.time = step * dt;
  const double t = frame.time;
  frame.robots.id = {-1};
  frame.robots.x = {0.5 * t};
  frame.robots.y = {std::sin(0.3 * t)};
  frame.robots.vx = {0.5};
  frame.robots.vy = {0.3 * std::cos(0.3 * t)};
  frame.robots.heading = {std::atan2(frame.robots.vy[0], frame.robots.vx[0])};
  frame.robots.omega = {0.1 * std::cos(t)};
  frame.robots.goal = {sim2d::kNoGoal};
  for (int k = 0; k < people; ++k) {
    const double angle = 0.4 * t + k;
    const double radius = 1.5 + 0.1 * k;
    frame.humans.id.push_back(k + 1);
    frame.humans.x.push_back(1.4 * k + radius * std::cos(angle));
    frame.humans.y.push_back(radius * std::sin(angle));
    frame.humans.vx.push_back(-0.4 * radius * std::sin(angle));
    frame.humans.vy.push_back(0.4 * radius * std::cos(angle));
    frame.humans.heading.push_back(base::wrapToPi(angle + base::kPi / 2));
    frame.humans.omega.push_back(0.4);
    frame.humans.group.push_back(k < 3 ? 7 : -1);
    frame.humans.state.push_back(step % 4 == 0 ? 1 : 0);
    frame.humans.goal.push_back(sim2d::kNoGoal);
  }
  return frame;
}

/// Walls beside the way and a map with a block.
inline sim2d::TraceHeader header(int people, double dt) {
  sim2d::TraceHeader made;
  made.dt = dt;
  for (int k = 0; k < people; ++k) {
    sim2d::TraceHuman human;
    human.id = k + 1;
    human.radius = 0.25 + 0.01 * k;
    human.behavior = 1 + k % 3;
    human.parameters = {{"social_force_factor", 4.0 + 0.1 * k}};
    made.humans.push_back(human);
  }
  sim2d::TraceRobot robot;
  robot.name = "robot1";
  robot.goals = {{0, base::Vec2(0.5 * 6.0, 0.0), 0.2}};
  made.robots = {robot};
  std::vector<std::int8_t> cells(std::size_t{200} * 80, 0);
  for (std::size_t row = 10; row < 14; ++row) {
    for (std::size_t column = 40; column < 60; ++column) {
      cells[row * 200 + column] = 100;
    }
  }
  made.map = sim2d::OccupancyGrid(200, 80, 0.2, {base::Vec2(-4.0, -6.0), 0.0}, cells);
  sim2d::TraceObstacle walls;
  walls.name = "map";
  walls.outlines = sim2d::traceOutlines(made.map);
  sim2d::TraceObstacle box;
  box.name = "box1";
  box.outlines = {sim2d::boxOutline({base::Vec2(2.0, 3.0), 0.3}, 1.0, 0.5)};
  sim2d::TraceObstacle door;
  door.name = "door1";
  door.isDoor = true;
  door.open = true;
  door.toggles = {1.0, 2.5};
  door.outlines = {sim2d::boxOutline({base::Vec2(5.0, 2.0), 0.0}, 2.0, 0.1)};
  made.obstacles = {walls, box, door};
  return made;
}

inline sim2d::Trace trace(int steps, int people, double dt = 0.05) {
  sim2d::Trace made;
  made.header = header(people, dt);
  for (int step = 0; step <= steps; ++step) {
    made.frames.push_back(frameAt(step, people, dt));
  }
  return made;
}

/// Turns and moves a trace without obstacles and map.
inline sim2d::Trace moved(sim2d::Trace trace, double angle, const base::Vec2& shift) {
  const base::Pose2 pose{shift, angle};
  const auto moveColumns = [&](auto& columns) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const base::Vec2 position = pose.toWorld(base::Vec2(columns.x[k], columns.y[k]));
      const base::Vec2 velocity =
          base::Pose2{base::Vec2(0, 0), angle}.toWorld(base::Vec2(columns.vx[k], columns.vy[k]));
      columns.x[k] = position.x();
      columns.y[k] = position.y();
      columns.vx[k] = velocity.x();
      columns.vy[k] = velocity.y();
      columns.heading[k] = base::wrapToPi(columns.heading[k] + angle);
    }
  };
  for (sim2d::Frame& frame : trace.frames) {
    moveColumns(frame.humans);
    moveColumns(frame.robots);
  }
  for (sim2d::TraceRobot& robot : trace.header.robots) {
    for (sim2d::TraceGoal& goal : robot.goals) {
      goal.position = pose.toWorld(goal.position);
    }
  }
  return trace;
}

inline metrics::MetricParameters parametersOf(metrics::Profile profile) {
  metrics::MetricParameters parameters;
  parameters.profile = profile;
  return parameters;
}

/// The first difference between two lists of results; empty when none is larger than `tolerance`
/// (relative).
inline std::string difference(const std::vector<metrics::MetricResult>& a,
                              const std::vector<metrics::MetricResult>& b, double tolerance) {
  if (a.size() != b.size()) {
    return "another number of results";
  }
  for (std::size_t k = 0; k < a.size(); ++k) {
    const std::optional<double>& left = a[k].value.value;
    const std::optional<double>& right = b[k].value.value;
    const bool same = left.has_value() == right.has_value() &&
                      (!left || *left == *right ||
                       std::fabs(*left - *right) <= tolerance * std::max(1.0, std::fabs(*left)));
    if (a[k].info.key != b[k].info.key || !same) {
      return a[k].info.key;
    }
  }
  return "";
}

}  // namespace cases
