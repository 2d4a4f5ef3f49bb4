#pragma once

#include <vector>

#include "sim2d/nav/SocialForce.h"

/// Optimal reciprocal collision avoidance (van den Berg, Guy, Lin & Manocha 2011, "Reciprocal
/// n-body collision avoidance") as pure functions. World frame, SI. Thread: any.
namespace sim2d {

/// Velocities on the left of the line through `point` along `direction` (unit vector) are allowed.
struct HalfPlane {
  Vec2 point = Vec2::Zero();
  Vec2 direction = Vec2(1.0, 0.0);
  /// How far a velocity lies on the wrong side [m/s]; <= 0: allowed.
  double violation(const Vec2& velocity) const { return base::cross(direction, point - velocity); }
};

/// `self` takes half of what keeps the two apart for `horizon` seconds; bodies that overlap part
/// within `dt`. For something that does not give way `share` is 1.
HalfPlane avoidBody(const Walker& self, const Walker& other, double horizon, double dt,
                    double share = 0.5);
/// Not into the boundary point within `horizon` seconds; inside an obstacle: out.
HalfPlane avoidPoint(const Walker& self, const Obstacles::Point& point, double horizon, double dt);

/// The allowed velocity nearest to `wanted` and not faster than `fastest`. The first `fixed` planes
/// hold as far as they can; when all together allow nothing, the rest is violated as little as
/// possible.
Vec2 nearestAllowed(const std::vector<HalfPlane>& planes, std::size_t fixed, const Vec2& wanted,
                    double fastest);

}  // namespace sim2d
