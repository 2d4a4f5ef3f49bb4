#pragma once

#include <array>
#include <vector>

#include "sim2d/map/Obstacles.h"
#include "sim2d/nav/Body.h"

/// Gap between a robot's footprint and other shapes [m]: 0 at contact, negative when overlapping.
/// Polygons are simple, convex or not. Thread-safe.
namespace sim2d {

/// Radius of the largest circle about the robot's origin inside its footprint [m]; 0 if the origin
/// lies outside.
double inscribedRadius(const Footprint& footprint);

/// Gap to a disc (`radius` 0: to a point), world frame. Exact for discs, and for polygons unless
/// they overlap by more than the disc's radius; then the true depth is at least that large (exact
/// for convex polygons). Does not allocate.
double gapToDisc(const Footprint& footprint, const Pose2& pose, const Vec2& centre, double radius);

/// Unit vectors at equal angles, starting at a heading [rad], for drawing outlines.
using OutlineDirections = std::array<Vec2, 12>;
OutlineDirections outlineDirections(double heading);
/// Convex polygon around the footprint, world frame. Every point outside it is at least `distance`
/// [m] (> 0) from the footprint, and its corners are at most `distance` times `kOutlineInflation`
/// away, except at concave corners. `directions`: of the pose's heading.
std::vector<Vec2> inflatedOutline(const Footprint& footprint, const Pose2& pose, double distance,
                                  const OutlineDirections& directions);
constexpr double kOutlineInflation = 1.0353;  // 1 / cos(15 degrees)

/// Gap to the nearest wall; `limit` (>= 0) if none is nearer. Exact when apart. When overlapping it
/// is minus the larger of two depths:
/// - the depth, inside the footprint, of the midpoint of the wall piece that it contains;
/// - the depth of the origin inside a solid plus the inscribed radius (if the origin is outside the
///   footprint: the depth of the first corner).
/// Disc: the signed distance of its centre (negative inside a solid) minus its radius. Depths
/// inside solids count up to `limit` plus the circumscribed radius.
double gapToWalls(const Footprint& footprint, const Pose2& pose, const Obstacles& obstacles,
                  double limit);

}  // namespace sim2d
