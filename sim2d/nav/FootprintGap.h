#pragma once

#include <array>
#include <vector>

#include "sim2d/map/Obstacles.h"
#include "sim2d/nav/Body.h"

/// Room between a robot's footprint and others [m]; 0 when they touch, negative when they overlap.
/// Polygons are simple, convex or not. Thread: any.
namespace sim2d {

/// Of the largest circle about the robot's origin that lies inside its footprint [m]; 0 when the
/// origin lies outside.
double inscribedRadius(const Footprint& footprint);

/// To a disc (`radius` 0: to a point), world frame. Exact for discs, and for polygons as long as
/// they do not overlap by more than the disc's radius; below, at least that deep (exact for convex
/// ones). Allocates nothing.
double gapToDisc(const Footprint& footprint, const Pose2& pose, const Vec2& centre, double radius);

/// Unit vectors all round from a heading on [rad], by which an outline is drawn.
using OutlineDirections = std::array<Vec2, 12>;
OutlineDirections outlineDirections(double heading);
/// A convex polygon round the footprint, world frame: no place outside of it is nearer to the
/// footprint than `distance` [m] (> 0), none of its corners farther away than `distance` times
/// `kOutlineExcess` but for those round notches. `directions`: of the pose's heading.
std::vector<Vec2> outlineAround(const Footprint& footprint, const Pose2& pose, double distance,
                                const OutlineDirections& directions);
constexpr double kOutlineExcess = 1.0353;  // 1 / cos(15 degrees)

/// To the nearest wall, `limit` (>= 0) when none is nearer. Exact apart; overlapping it is minus
/// the larger of two depths:
/// - how far inside of the footprint the middle of the piece of a wall's border lies that it holds;
/// - how deep the origin lies inside of something solid, plus the inscribed radius (an origin
///   outside of the footprint: how deep the first corner lies there).
/// A disc: the distance of its centre (negative inside of something solid) less its radius.
/// Depths in something solid count up to `limit` plus the footprint's reach.
double gapToWalls(const Footprint& footprint, const Pose2& pose, const Obstacles& obstacles,
                  double limit);

}  // namespace sim2d
