#pragma once

#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Areas of kind `speed`: stairs, ramps and travelators. Where several overlap, factors multiply
/// and velocities add. Points of their edges belong to one side as in `isInside`.

/// Factor of a person's desired speed at this position; 1 outside of all zones.
double speedFactorAt(const WorldModel& model, const Vec2& position);

/// Velocity with which people at this position are carried [m/s], also while they stand.
Vec2 carryingVelocityAt(const WorldModel& model, const Vec2& position);

}  // namespace sim2d
