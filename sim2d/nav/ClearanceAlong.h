#pragma once

#include <vector>

#include "sim2d/nav/Body.h"
#include "sim2d/nav/ClearanceCache.h"
#include "sim2d/nav/Observation.h"

namespace sim2d {

/// How near a robot would come to walls, points of its scan and people, who are taken to go on
/// at constant velocity, along a way of poses at equal times. One robot; thread: one at a time.
class ClearanceAlong {
 public:
  /// `wide`: room beyond which more does not count [m].
  ClearanceAlong(const RobotBody& body, double wide);

  /// Takes over the observation for the questions that follow. Nearer than `margin` [m] counts as
  /// hit; what is nearer already, when the robot comes nearer still. People that cannot come near
  /// within `time` [s] at the robot's speed of at most `speed` [m/s] are left out.
  void observe(const Observation& observation, double margin, double speed, double time);

  struct Way {
    const std::vector<Pose2>& poses;  // the present one first
    double step = 0.1;                // [s] between them
    double speed = 1.0;               // at most that of the centre [m/s]
  };
  struct Found {
    int wallStep = 0;  // of the first pose that hits a wall or a point; poses.size(): none does
    int bodyStep = 0;  // idem, of people and robots
    double gap = 0.0;  // the least room until then [m]; `wide` at most
  };
  Found along(const Way& way);

  /// Whether the robot stands before it hits anything, when it follows the way for `hold` [s] and
  /// then brakes evenly within `stopTime` [s]. For walls that is v <= sqrt(2 d a) (Fox, Burgard &
  /// Thrun 1997, eq. 14) with the room d left after `hold`; what walks into the robot without its
  /// coming nearer does not count.
  bool canStop(const Way& way, const Found& found, double hold, double stopTime) const;

  /// Of the scan that are neither known walls nor known bodies: world frame [m].
  const std::vector<Vec2>& points() const { return points_; }
  /// To the nearest body ahead of the robot now [m]; infinite when there is none near.
  double gapAhead() const { return gapAhead_; }

 private:
  struct Near {
    Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();
    double radius = 0.0;
    double speed = 0.0;
    double least = 0.0;   // gap below which it is hit [m]
    double gapNow = 0.0;  // [m]
  };
  void takeBodies(const Observation& observation, double speed, double time);
  void takePoints(const Observation& observation);
  bool isKnown(const Observation& observation, const Vec2& point) const;
  double leastOf(double gapNow) const;
  double gapTo(const Near& body, const Pose2& pose, double time) const;
  double gapToWall(const Pose2& pose);
  void followWalls(const Way& way, Found& found);
  void followBody(const Way& way, const Near& body, Found& found) const;
  bool isHitWhile(const Pose2& before, const Pose2& pose, double time) const;

  RobotBody body_;
  double reach_, wide_;
  double margin_ = 0.0;
  double wallLeast_ = 0.0;  // gap to walls below which they are hit [m]
  double gapAhead_ = 0.0;
  ClearanceCache cache_;
  std::vector<Near> near_;
  std::vector<Vec2> points_;
  double scanTime_ = -1e9;  // [s]
  const Obstacles* obstacles_ = nullptr;
};

}  // namespace sim2d
