#pragma once

#include <limits>
#include <string>
#include <vector>

#include "sim2d/base/Types.h"

/// What a robot is, as far as its own software may know. SI, robot frame: x ahead, y to the left.
namespace sim2d {

using base::Pose2;
using base::Vec2;

enum class Kinematics { Differential, Omnidirectional, Ackermann };
const char* kinematicsName(Kinematics kinematics);  // "differential" …

/// Motion of a body in its own frame, or the wish for one. Only omnidirectional robots go sideways.
struct BodyTwist {
  double linear = 0.0;   // v_x [m/s], ahead
  double angular = 0.0;  // omega [rad/s], counter-clockwise
  double lateral = 0.0;  // v_y [m/s], to the left

  friend bool operator==(const BodyTwist& a, const BodyTwist& b) {
    return a.linear == b.linear && a.angular == b.angular && a.lateral == b.lateral;
  }
  friend bool operator!=(const BodyTwist& a, const BodyTwist& b) { return !(a == b); }
};

/// What the drive can do. An omnidirectional robot has `maxVel` and `maxAcc` in each direction.
struct DriveLimits {
  double maxVel = 1.0;         // [m/s], ahead
  double maxReverse = 1.0;     // [m/s], backwards, >= 0
  double maxAcc = 1.0;         // [m/s²], speeding up and slowing down
  double maxOmega = 1.5;       // [rad/s]
  double maxAlpha = 3.0;       // [rad/s²]
  double turningRadius = 0.0;  // [m]; Ackermann: the least
};

/// A disc, or a simple polygon in robot frame, counter-clockwise (then `radius` is not used).
struct Footprint {
  double radius = 0.35;  // [m]
  std::vector<Vec2> corners;

  bool isDisc() const { return corners.empty(); }
};

/// Of the smallest circle about the robot's origin that holds it [m].
double reachOf(const Footprint& footprint);

struct RobotBody {
  Kinematics kinematics = Kinematics::Differential;
  Footprint footprint;
  DriveLimits limits;
  double mass = 50.0;  // [kg]
};

}  // namespace sim2d
