#pragma once

#include <limits>
#include <string>
#include <vector>

#include "sim2d/base/Types.h"

/// Properties of a robot's body that its own software may use. SI units, robot frame: x forward, y
/// left.
namespace sim2d {

using base::Pose2;
using base::Vec2;

enum class Kinematics { Differential, Omnidirectional, Ackermann };
const char* kinematicsName(Kinematics kinematics);  // "differential" …

/// Velocity of a body in its own frame, or a commanded one. `lateral` is nonzero for
/// omnidirectional robots only.
struct BodyTwist {
  double linear = 0.0;   // v_x [m/s], forward
  double angular = 0.0;  // omega [rad/s], counter-clockwise
  double lateral = 0.0;  // v_y [m/s], to the left

  friend bool operator==(const BodyTwist& a, const BodyTwist& b) {
    return a.linear == b.linear && a.angular == b.angular && a.lateral == b.lateral;
  }
  friend bool operator!=(const BodyTwist& a, const BodyTwist& b) { return !(a == b); }
};

/// Limits of the drive. An omnidirectional robot has `maxVel` and `maxAcc` in each direction.
struct DriveLimits {
  double maxVel = 1.0;         // [m/s], forward
  double maxReverse = 1.0;     // [m/s], backward, >= 0
  double maxAcc = 1.0;         // [m/s²], for acceleration and deceleration
  double maxOmega = 1.5;       // [rad/s]
  double maxAlpha = 3.0;       // [rad/s²]
  double turningRadius = 0.0;  // [m]; Ackermann: the minimum
};

/// A disc, or a simple polygon in robot frame, counter-clockwise (`radius` is then unused).
struct Footprint {
  double radius = 0.35;  // [m]
  std::vector<Vec2> corners;

  bool isDisc() const { return corners.empty(); }
};

/// Circumscribed radius: of the smallest circle about the robot's origin that encloses it [m].
double circumscribedRadius(const Footprint& footprint);

struct RobotBody {
  Kinematics kinematics = Kinematics::Differential;
  Footprint footprint;
  DriveLimits limits;
  double mass = 50.0;  // [kg]
};

/// Energy model of a robot battery, without ageing, losses or temperature.

struct BatteryParameters {
  double capacity = 0.0;       // [Wh]; 0: no battery, the robot always has power
  double level = 1.0;          // charge at the start, 0 to 1
  double idlePower = 20.0;     // [W], while the robot stands still
  double motionPower = 60.0;   // [W], in addition at top speed or top turn rate
  double chargePower = 120.0;  // [W], into the battery at a charging dock
  double emptyVoltage = 21.0;  // [V], at level 0
  double fullVoltage = 25.2;   // [V], at level 1

  bool exists() const { return capacity > 0.0; }
};

/// Measurements of a battery monitor.
struct BatteryState {
  double level = 1.0;    // charge, 0 to 1
  double voltage = 0.0;  // [V]
  double current = 0.0;  // [A], positive while it is charged
  bool isCharging = false;
};

/// Drive effort of a motion, 0 to 1: the larger of speed / max speed and turn rate / max turn rate.
double driveEffort(const BodyTwist& motion, const DriveLimits& limits);

/// Power into the battery [W]: the charge power at a charger, which then also supplies the robot;
/// otherwise -(idle + motion * effort).
double batteryPower(const BatteryParameters& battery, double effort, bool isCharging);

/// Charge level after `dt` [s]: level + power dt / (3600 capacity), clamped to [0, 1].
double chargeLevelAfter(const BatteryParameters& battery, double level, double power, double dt);

/// Voltage (linear in the level) and current.
BatteryState batteryState(const BatteryParameters& battery, double level, double power,
                          bool isCharging);

/// Poses in moving frames: map, odom, robot (REP 105). A frame is given by its pose in its parent
/// frame. Headings are in (-pi, pi].

inline bool isIdentity(const base::Pose2& frame) {
  return frame == base::Pose2{};
}

/// Converts a pose from `frame` to the parent of `frame`. With the identity, the result is
/// bit-identical.
inline base::Pose2 toParent(const base::Pose2& frame, const base::Pose2& inFrame) {
  if (isIdentity(frame)) {
    return inFrame;
  }
  return {frame.toWorld(inFrame.position), base::wrapToPi(frame.heading + inFrame.heading)};
}

/// Inverse: converts a pose from the parent of `frame` to `frame`.
inline base::Pose2 toFrame(const base::Pose2& frame, const base::Pose2& inParent) {
  if (isIdentity(frame)) {
    return inParent;
  }
  return {frame.toLocal(inParent.position), base::angleDiff(inParent.heading, frame.heading)};
}

/// The pose of the parent in `frame`.
inline base::Pose2 inverse(const base::Pose2& frame) {
  return toFrame(frame, base::Pose2{});
}

/// The frame in which the pose `inParent` has the coordinates `inFrame`.
inline base::Pose2 frameBetween(const base::Pose2& inParent, const base::Pose2& inFrame) {
  if (inParent == inFrame) {
    return {};
  }
  base::Pose2 frame{base::Vec2::Zero(), base::angleDiff(inParent.heading, inFrame.heading)};
  frame.position = inParent.position - frame.toWorld(inFrame.position);
  return frame;
}

}  // namespace sim2d
