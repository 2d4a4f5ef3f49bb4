#pragma once

#include <vector>

#include "sim2d/map/Obstacles.h"

namespace sim2d {

/// The way pulled tight: as short as it gets without being lifted over an obstacle, for a disc that
/// keeps `clearance` [m] from all borders (less where the way begins or ends closer). Straight
/// lines, and arcs round corners as chords, to 2e-4 of the length of the shortest that passes all
/// obstacles on the same sides; another side may be shorter. The way given must be clear but for
/// what a planning grid rounds.
std::vector<Vec2> tautened(const std::vector<Vec2>& way, const Obstacles& obstacles,
                           double clearance);

/// Whether a disc gets straight from one point to the other with `clearance` [m] to all borders;
/// half a millimetre at least.
bool isWayClear(const Vec2& from, const Vec2& to, const Obstacles& obstacles, double clearance);

/// Smallest distance between the points of two segments [m].
double distanceBetween(const Segment& first, const Segment& second);

}  // namespace sim2d
