#pragma once

#include <utility>
#include <vector>

#include "sim2d/base/Types.h"
#include "sim2d/nav/Observation.h"

namespace sim2d {

/// Route of one robot around the walls to its goal, for local planners that follow one. World
/// frame, [m].
class RobotRoute {
 public:
  /// Plans if there is no route to this goal yet, when a door has moved, or, at most once a second,
  /// when the robot is off the route or cannot see the point `sight` ahead of it.
  void update(const Observation& observation, double bodyRadius, double sight);

  bool isEmpty() const { return points_.empty(); }
  const std::vector<Vec2>& points() const { return points_; }
  /// Point at `distance` along the route from its point nearest to `position`; its end if the route
  /// is shorter. The route must not be empty.
  Vec2 pointAhead(const Vec2& position, double distance) const;
  /// Length from the point nearest to `position` to the end [m]; distance to that point [m].
  double remainingLength(const Vec2& position) const;
  double distanceFrom(const Vec2& position) const;
  /// True if it was replanned for the same goal since the last call.
  bool takeReplanned() { return std::exchange(replanned_, false); }

 private:
  struct Projection {
    std::size_t leg = 0;
    Vec2 point = Vec2::Zero();
  };
  Projection projectionOf(const Vec2& position) const;
  bool needsPlan(const Observation& observation, double sight) const;

  std::vector<Vec2> points_;
  Vec2 goal_ = Vec2::Zero();
  int version_ = -1;  // of the navigation map; -1: never planned
  double planTime_ = -1e9;
  bool replanned_ = false;
};

/// Desired velocity of a robot, for planners that choose velocities. World frame, SI. Objects are
/// not thread-safe.

/// Velocity towards the point `lookahead` [m] farther along the route, at most `speed` [m/s] and
/// slow enough to stop at the goal; zero within half of the goal radius. The route must not be
/// empty.
Vec2 routeVelocity(const RobotRoute& route, const Observation& observation, double lookahead,
                   double speed, double maxAcc);

/// Side to which a robot evades people: slightly to the right, so that symmetric encounters are
/// resolved. A robot without progress for some seconds and with people nearby takes a detour to the
/// other side, then back to the first one; the waiting time and the detour double each time.
class PassingSide {
 public:
  explicit PassingSide(double preference) : preference_(preference) {}  // [rad]

  /// Call once per step with the remaining route length [m].
  void update(const Observation& observation, double remainingLength);
  /// Rotation of the desired velocity when people are in the way [rad], counter-clockwise.
  double turn() const { return side_ * preference_; }
  /// Additional rotation during a detour [rad]; otherwise 0.
  double detour() const;
  /// True if a detour has begun since the last call.
  bool takeChanged();

 private:
  void recordProgress(const Observation& observation, double remainingLength);

  double preference_;
  double side_ = -1.0;  // -1 right, 1 left
  bool isOnDetour_ = false;
  bool hasChanged_ = false;
  Vec2 goal_ = Vec2::Zero();
  double minRemaining_ = -1.0;  // minimum remaining length since the last change [m]; < 0: none yet
  double remainingAtChange_ = 0.0;  // remaining length at the last change [m]
  double bestTime_ = 0.0;           // time of the last progress [s]
  double detourUntil_ = 0.0;        // [s]
  double patience_ = 0.0;           // [s]
};

using base::Vec2;

/// Detects that a robot makes no progress; then the robot moves away a little and accepts a smaller
/// margin, repeatedly until it progresses. Waiting alone would not help, because a person may keep
/// standing in the way. Not thread-safe.
class StuckDetector {
 public:
  /// After `patience` [s] without progress the robot moves away by `distance` [m].
  StuckDetector(double patience, double distance) : patience_(patience), distance_(distance) {}

  /// Call once per step. `rest`: remaining path length [m], including turns; a changed `goal`
  /// resets the state.
  void update(double time, const Vec2& position, const Vec2& goal, double rest);

  bool isRecovering() const { return isRecovering_; }
  /// Number of consecutive recoveries without success.
  int tries() const { return tries_; }
  /// Scale of the margin to obstacles: 1 normally, down to 0.2.
  double marginScale() const { return share_; }
  /// True in the step in which a recovery begins.
  bool hasJustStarted() const { return hasJustStarted_; }

 private:
  double patience_, distance_;
  bool isFirst_ = true;
  bool isRecovering_ = false;
  bool hasJustStarted_ = false;
  int tries_ = 0;
  double share_ = 1.0;
  double since_ = 0.0;           // time of the last progress, or of the start of the recovery [s]
  double minRemaining_ = 0.0;    // rest at the last progress [m]
  double remaining_ = 0.0;       // in the last step [m]
  double stuckRemaining_ = 0.0;  // rest when it got stuck [m]
  Vec2 startPosition_ = Vec2::Zero();  // position at the start of the recovery
  Vec2 goal_ = Vec2::Zero();
};

}  // namespace sim2d
