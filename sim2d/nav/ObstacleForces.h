#pragma once

#include <vector>

#include "sim2d/nav/SocialForce.h"

namespace sim2d {

/// The force of each point of an obstacle (`obstacleForce`), in their order; takes the place of
/// what `forces` held.
void obstacleForces(const ForceParameters& parameters, const Walker& self,
                    const std::vector<Obstacles::Point>& points, std::vector<Vec2>& forces);

}  // namespace sim2d
