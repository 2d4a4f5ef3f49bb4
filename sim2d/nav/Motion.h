#pragma once

#include "sim2d/nav/Body.h"

/// How robots move: closed forms. World frame for poses, robot frame for twists, SI. Finite numbers
/// in, finite numbers out. Thread: any.
namespace sim2d {

/// The pose after `time` [s] with a constant twist: the exact arc (a straight line without
/// turning), smooth where the turn vanishes. A sideways part turns with the robot.
Pose2 advanced(const Pose2& pose, const BodyTwist& twist, double time);

/// The wish without what this drive cannot do at all: each component within its limit of speed; no
/// sideways part unless omnidirectional; Ackermann: no tighter turn than `turningRadius` (none
/// while standing), the speed has precedence.
BodyTwist feasible(const RobotBody& body, const BodyTwist& wanted);
/// What the drive makes of the wish within `time` [s], coming from `now`: feasible, and no
/// component changes faster than its limit. From above a limit of speed it slows down at that rate
/// (so it may still be above it). Ackermann: wheels at full lock turn the less the slower they go,
/// even when that brakes the turn faster than `maxAlpha`.
BodyTwist reached(const RobotBody& body, const BodyTwist& now, const BodyTwist& wanted,
                  double time);

/// All twists that are reached within `time` (the dynamic window of Fox, Burgard & Thrun 1997).
/// Ackermann: the smallest box that holds them; `reached` sorts out the turns that are too tight.
struct TwistWindow {
  double lowLinear = 0.0, highLinear = 0.0;    // [m/s]
  double lowAngular = 0.0, highAngular = 0.0;  // [rad/s]
  double lowLateral = 0.0, highLateral = 0.0;  // [m/s]; 0 unless omnidirectional
};
TwistWindow windowOf(const RobotBody& body, const BodyTwist& now, double time);

/// From this twist to standing with full braking: length of the way of the centre [m], v² / 2a.
/// Omnidirectional: both directions brake at once. Infinite for a robot that moves and cannot
/// brake.
double brakingDistance(const RobotBody& body, const BodyTwist& twist);

}  // namespace sim2d
