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

}  // namespace sim2d
