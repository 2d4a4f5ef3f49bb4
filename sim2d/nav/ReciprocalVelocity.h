#pragma once

#include <vector>

#include "sim2d/nav/SocialForce.h"

/// Optimal reciprocal collision avoidance (van den Berg, Guy, Lin & Manocha 2011, "Reciprocal
/// n-body collision avoidance") as pure functions. World frame, SI. Thread-safe.
namespace sim2d {

/// Velocities on the left of the line through `point` along `direction` (unit vector) are allowed.
struct HalfPlane {
  Vec2 point = Vec2::Zero();
  Vec2 direction = Vec2(1.0, 0.0);
  /// Signed distance of a velocity to the boundary [m/s]; <= 0: allowed.
  double violation(const Vec2& velocity) const { return base::cross(direction, point - velocity); }
};

/// Half plane in which `self` takes the part `share` of avoiding `other` for `horizon` seconds;
/// overlapping bodies separate within `dt`. Use 1 for bodies that do not avoid `self`.
HalfPlane bodyHalfPlane(const Walker& self, const Walker& other, double horizon, double dt,
                        double share = 0.5);
/// Half plane of velocities that do not reach the boundary point within `horizon` seconds; inside
/// an obstacle they lead outward.
HalfPlane pointHalfPlane(const Walker& self, const Obstacles::Point& point, double horizon,
                         double dt);

/// The allowed velocity nearest to `wanted` with a speed of at most `fastest`. The first `fixed`
/// planes have priority; if all planes together are infeasible, the violation of the others is
/// minimised.
Vec2 nearestFeasibleVelocity(const std::vector<HalfPlane>& planes, std::size_t fixed,
                             const Vec2& wanted, double fastest);

}  // namespace sim2d
