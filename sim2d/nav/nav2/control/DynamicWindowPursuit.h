#pragma once

#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/control/PursuitParameters.h"

/// Dynamic window pure pursuit (main): the velocities nearest to a curvature that the accelerations
/// allow (dynamic_window_pure_pursuit_functions.hpp; Ohnishi, Takahashi 2025).
namespace sim2d::nav2 {

struct VelocityWindow {
  double minLinear = 0.0, maxLinear = 0.0;    // [m/s]
  double minAngular = 0.0, maxAngular = 0.0;  // [rad/s]
};

/// What can be reached from a velocity within `dt` [s].
VelocityWindow velocityWindow(const PursuitParameters& parameters, const BodyTwist& now, double dt);
/// Its part between standing and the regulated speed [m/s]; a single speed when there is none.
VelocityWindow regulatedWindow(VelocityWindow window, double speed);
/// The fastest point of the window on the line omega = kappa v, else its corner nearest to it.
/// `sign` < 0: backwards.
BodyTwist bestInWindow(const VelocityWindow& window, double curvature, double sign);

}  // namespace sim2d::nav2
