#pragma once

#include <vector>

#include "sim2d/nav/SocialForce.h"

namespace sim2d {

/// `obstacleForce` [m/s^2] of each point of a wall by itself, in their order and with the same
/// bits; they take the place of what `forces` held. In SocialForce.cpp, beside it. Any thread.
void obstacleForces(const ForceParameters& parameters, const Walker& self,
                    const std::vector<Obstacles::Point>& points, std::vector<Vec2>& forces);

}  // namespace sim2d
