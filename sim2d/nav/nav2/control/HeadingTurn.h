#pragma once

/// Turning on the spot towards an angle, as pursuit and the rotation shim do.
namespace sim2d::nav2 {

struct HeadingTurn {
  double angularVelocity = 1.8;      // [rad/s]
  double angularAcceleration = 3.2;  // [rad/s^2]
};

/// The angular velocity [rad/s] towards `angle` [rad, seen from the robot] at the velocity `now`:
/// reached within a step `dt` [s], and no faster than what can be braked over the angle.
double turnVelocity(const HeadingTurn& turn, double angle, double now, double dt);

}  // namespace sim2d::nav2
