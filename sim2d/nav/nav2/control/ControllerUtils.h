#pragma once

#include <algorithm>
#include <cmath>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

/// Turning in place towards an angle, used by pure pursuit and the rotation shim.
namespace sim2d::nav2 {

struct RotationLimits {
  double angularVelocity = 1.8;      // [rad/s]
  double angularAcceleration = 3.2;  // [rad/s^2]
};

/// The angular velocity [rad/s] towards `angle` [rad, relative to the robot] at the velocity `now`:
/// reachable within a step `dt` [s], and low enough to stop within the angle.
inline double rotationVelocity(const RotationLimits& turn, double angle, double now, double dt) {
  const double sign = angle > 0.0 ? 1.0 : -1.0;
  const double acceleration = std::max(turn.angularAcceleration, 0.0);
  const double change = acceleration * dt;
  const double reached = std::clamp(sign * turn.angularVelocity, now - change, now + change);
  const double brakable = std::sqrt(2.0 * acceleration * std::abs(angle));
  return std::abs(reached) > brakable ? sign * brakable : reached;
}

/// Whether the edges of the footprint at a pose touch an obstacle, or unknown space if the costmap
/// does not track it; false where the robot's centre is off the map. Round robots are also checked
/// by their polygon.
inline bool isPoseInCollision(const ControlInput& input, const Pose2& pose) {
  return input.costmap.worldToCell(pose.position) &&
         isEdgeCollision(footprintCost(input.costmap, input.shape.vertices, pose),
                         input.shape.tracksUnknown);
}

/// Transforms poses into the robot's frame; computes sine and cosine once.
class RobotFrame {
 public:
  explicit RobotFrame(const Pose2& robot) : robot_(robot), axis_(robot.direction()) {}
  Pose2 toLocal(const Pose2& pose) const {
    const Vec2 offset = pose.position - robot_.position;
    return {Vec2(axis_.dot(offset), base::cross(axis_, offset)),
            base::angleDiff(pose.heading, robot_.heading)};
  }

 private:
  Pose2 robot_;
  Vec2 axis_;
};

}  // namespace sim2d::nav2
