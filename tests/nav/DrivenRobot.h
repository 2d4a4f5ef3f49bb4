#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "tests/nav/DriveWorld.h"

/// A robot that a planner drives through a small world of walls and of people who walk on and do
/// not react, for tests of planners. Odometry and detection are perfect.
namespace driven {

using namespace sim2d;

/// Blocks of wall in the open plane.
class Place {
 public:
  explicit Place(const std::vector<std::pair<Vec2, Vec2>>& blocks = {},
                 const std::vector<Vec2>& corners = {Vec2(-10.0, -10.0), Vec2(10.0, 10.0)}) {
    for (const auto& [low, high] : blocks) {
      obstacles_.add({drive::wall(low.x(), low.y(), high.x(), high.y())});
    }
    obstacles_.build();
    navigation_ = std::make_unique<NavigationMap>(OccupancyGrid(), obstacles_, corners);
  }
  const Obstacles& obstacles() const { return obstacles_; }
  const NavigationMap& navigation() const { return *navigation_; }

 private:
  Obstacles obstacles_;
  std::unique_ptr<NavigationMap> navigation_;
};

inline RobotBody bodyOf(Kinematics kinematics) {
  RobotBody body;
  body.kinematics = kinematics;
  body.footprint.radius = 0.3;
  if (kinematics == Kinematics::Ackermann) {
    body.limits.turningRadius = 0.6;
    body.limits.maxReverse = 0.5;
  }
  return body;
}

using drive::person;

/// What came of it.
struct Drive {
  bool hasArrived = false;
  double time = 0.0;          // [s]
  double leastGap = 1e9;      // to people [m]
  double leastWallGap = 1e9;  // [m]
  bool droveInto = false;     // was nearer to somebody than 0 by its own motion
  int turns = 0;              // how often it changed the side to which it turns
  std::vector<Pose2> poses;
};

class Robot {
 public:
  Robot(const Place& place, const RobotBody& body, const Pose2& start, const Vec2& goal)
      : place_(place), body_(body) {
    seen_.pose = start;
    seen_.goal = goal;
    seen_.obstacles = &place.obstacles();
    seen_.navigation = &place.navigation();
  }
  Observation& seen() { return seen_; }

  /// One step; others move on with their velocities.
  void step(Planner& planner, Drive& drive) {
    const BodyTwist command = *planner.command(seen_);
    const Pose2 before = seen_.pose;
    seen_.motion = reached(body_, seen_.motion, command, seen_.dt);
    seen_.pose = propagated(before, seen_.motion, seen_.dt);
    seen_.time += seen_.dt;
    for (TrackedBody& other : seen_.bodies) {
      other.position += seen_.dt * other.velocity;
      const double gap = gapToDisc(body_.footprint, seen_.pose, other.position, other.radius);
      const double stood = gapToDisc(body_.footprint, before, other.position, other.radius);
      drive.leastGap = std::min(drive.leastGap, gap);
      drive.droveInto = drive.droveInto || (gap < 0.0 && gap < stood - 1e-9);
    }
    drive.leastWallGap = std::min(drive.leastWallGap,
                                  gapToWalls(body_.footprint, seen_.pose, place_.obstacles(), 5.0));
    countTurns(drive);
    drive.poses.push_back(seen_.pose);
  }

  Drive driveFor(Planner& planner, double seconds) {
    Drive drive;
    const int steps = static_cast<int>(std::lround(seconds / seen_.dt));
    for (int i = 0; i < steps && !drive.hasArrived; ++i) {
      step(planner, drive);
      drive.hasArrived = (seen_.pose.position - seen_.goal).norm() < seen_.goalRadius;
    }
    drive.time = seen_.time;
    return drive;
  }

 private:
  void countTurns(Drive& drive) {
    constexpr double kTurning = 0.1;  // [rad/s]
    const double omega = seen_.motion.angular;
    if (std::fabs(omega) > kTurning) {
      const double side = omega > 0.0 ? 1.0 : -1.0;
      drive.turns += side * side_ < 0.0 ? 1 : 0;
      side_ = side;
    }
  }

  const Place& place_;
  RobotBody body_;
  Observation seen_;
  double side_ = 0.0;
};

}  // namespace driven
