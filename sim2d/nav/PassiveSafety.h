#pragma once

#include <vector>

#include "sim2d/nav/Observation.h"

/// The rule by which a robot never drives into what it knows of: it stands before anything touches
/// it ("passive motion safety", Macek, Vasquez, Fraichard & Siegwart 2009; Bouraine, Fraichard &
/// Salhi 2012). World frame, SI. Thread: any.
namespace sim2d {

/// The robot takes the twist within one step, keeps it for that step, then brakes until it stands.
/// True: all that time it keeps `margin` [m] to everybody, who go on with constant velocity, and to
/// walls, or comes no nearer to them than if it stood.
bool isPassivelySafe(const RobotBody& body, const Observation& observation, const BodyTwist& twist,
                     double margin);

/// The twist, within one step of `observation.motion`, nearest to the wanted one that is passively
/// safe: as wanted, slower, turning on the spot, or braking when nothing else is left. While the
/// last one was safe and people go on as they went, braking is.
BodyTwist passivelySafe(const RobotBody& body, const Observation& observation,
                        const BodyTwist& wanted, double margin);

}  // namespace sim2d
