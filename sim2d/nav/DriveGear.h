#pragma once

#include "sim2d/nav/NonholonomicTracking.h"
#include "sim2d/nav/Observation.h"

/// Which way a robot drives, for planners that choose velocities. World frame, SI.
namespace sim2d {

/// What a robot would like, in the frame in which it drives ahead.
struct DriveAim {
  TrackingModel model;
  double heading = 0.0;        // [rad], of the end that is in front
  Vec2 wanted = Vec2::Zero();  // [m/s]
  bool isBacking = false;

  /// The robot's command for a twist of that frame.
  BodyTwist commandOf(const BodyTwist& twist) const;
};

/// The gear of an Ackermann robot. It backs up when the point that it steers to lies inside of its
/// turning circles, which no forward arc reaches, and when it has stood still for a second. Other
/// robots always drive ahead. Thread: one at a time.
class DriveGear {
 public:
  DriveGear(const RobotBody& body, double turnTime);  // T [s] of the tracking

  /// Called once per step. `target`: where it steers to [m]; `wanted`: as if it could go to all
  /// sides. A car that cannot track that within `epsilon` [m] steers as far aside as it can.
  DriveAim choose(const Observation& observation, const Vec2& target, const Vec2& wanted,
                  double epsilon);
  /// Nearer points on a route cannot be steered to [m].
  double leastLookahead() const;

 private:
  bool isOutOfReach(const Vec2& target, double radius) const;
  void update(const Observation& observation, const Vec2& target, bool wantsToMove);

  TrackingModel model_;
  double maxReverse_;  // [m/s]
  bool isBacking_ = false;
  double since_ = -1e9;    // of the last change of gear [s]
  double movedAt_ = -1.0;  // when it last moved, or did not want to [s]; < 0: never asked
};

}  // namespace sim2d
