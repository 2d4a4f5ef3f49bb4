#pragma once

#include "sim2d/nav/Observation.h"
#include "sim2d/nav/RobotRoute.h"

/// The velocity that a robot would like to have, for planners that choose velocities. World frame,
/// SI. Thread: one at a time for each object.
namespace sim2d {

/// Towards the point `lookahead` [m] farther along the route, with `speed` [m/s] at most, so slow
/// that the robot comes to a stand at the goal; zero within half of the goal's radius. The route is
/// not empty.
Vec2 velocityAlong(const RobotRoute& route, const Observation& observation, double lookahead,
                   double speed, double maxAcc);

/// To which side a robot gives way to people: a little to the right, so that symmetric meetings
/// are decided. A robot that does not get on for some seconds with somebody near goes a detour to
/// the other side, and back to this one when that does not help either; each time it waits twice as
/// long and goes farther.
class PassingSide {
 public:
  explicit PassingSide(double preference) : preference_(preference) {}  // [rad]

  /// Called once per step with what is left of the way [m].
  void update(const Observation& observation, double restLength);
  /// By how much the wanted velocity is turned where people are in its way [rad],
  /// counter-clockwise.
  double turn() const { return side_ * preference_; }
  /// By how much it is turned in any case, for a detour [rad]; 0 mostly.
  double detour() const;
  /// A detour has begun since the last call.
  bool takeChanged();

 private:
  void noteProgress(const Observation& observation, double restLength);

  double preference_;
  double side_ = -1.0;  // -1 right, 1 left
  bool isOnDetour_ = false;
  bool hasChanged_ = false;
  Vec2 goal_ = Vec2::Zero();
  double best_ = -1.0;        // least length left since the last change [m]; < 0: none yet
  double atChange_ = 0.0;     // length left then [m]
  double bestTime_ = 0.0;     // of progress [s]
  double detourUntil_ = 0.0;  // [s]
  double patience_ = 0.0;     // [s]
};

}  // namespace sim2d
