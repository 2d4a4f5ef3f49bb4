#pragma once

#include <vector>

#include "sim2d/nav/Observation.h"

/// Passive motion safety: the robot has stopped before anything that it perceives touches it
/// (Macek, Vasquez, Fraichard & Siegwart 2009; Bouraine, Fraichard & Salhi 2012). World frame, SI.
/// Thread-safe.
namespace sim2d {

/// The robot changes to the twist within one step, keeps it for that step, then brakes to a
/// standstill. True if it keeps `margin` [m] to all bodies (at constant velocity) and walls all
/// that time, or comes no nearer to them than if it stood still.
bool isPassivelySafe(const RobotBody& body, const Observation& observation, const BodyTwist& twist,
                     double margin);

/// Twist nearest to the wanted one that is reachable within one step from `observation.motion` and
/// passively safe: as wanted, slower, turning in place, or else braking. Braking is safe if the
/// last twist was safe and people keep their velocities.
BodyTwist nearestSafeTwist(const RobotBody& body, const Observation& observation,
                           const BodyTwist& wanted, double margin);

}  // namespace sim2d
