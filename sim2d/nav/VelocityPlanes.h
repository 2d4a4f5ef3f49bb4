#pragma once

#include <vector>

#include "sim2d/nav/Observation.h"
#include "sim2d/nav/ReciprocalVelocity.h"

/// What all planners that choose velocities by half planes share. World frame, SI. Thread: any.
namespace sim2d {

/// Those whose centre lies within `range` [m] and that no wall hides, nearest first, at most 24.
std::vector<TrackedBody> visibleBodies(const Observation& observation, double range);

/// Velocities that do not lead into walls within `horizon` [s] by more than what is left of
/// `radius` [m] where there is less room. They hold zero and a bit of all directions, unless the
/// robot's centre is inside of a wall.
std::vector<HalfPlane> wallPlanes(const Observation& observation, double radius, double speed,
                                  double horizon);

/// From the body's frame to the world's, or back with the opposite heading.
HalfPlane turnedBy(const HalfPlane& plane, double heading);
Vec2 turnedBy(const Vec2& vector, double angle);

/// Greatest violation by this velocity of the planes from `first` on [m/s]; 0 if there is none.
double worstViolation(const std::vector<HalfPlane>& planes, std::size_t first,
                      const Vec2& velocity);

}  // namespace sim2d
