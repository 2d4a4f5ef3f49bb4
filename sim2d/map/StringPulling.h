#pragma once

#include <vector>

#include "sim2d/map/Obstacles.h"

namespace sim2d {

/// Tightens a path: the shortest one that passes all obstacles on the same sides, for a disc that
/// keeps `clearance` [m] from all borders (less where the path begins or ends closer). Straight
/// lines, and chords for arcs around corners; accurate to 2e-4 of the length. The given path must
/// be free up to the rounding of a planning grid.
std::vector<Vec2> tightened(const std::vector<Vec2>& path, const Obstacles& obstacles,
                            double clearance);

/// Whether a disc can move straight between two points with `clearance` [m] to all borders (at
/// least half a millimetre).
bool isSegmentFree(const Vec2& from, const Vec2& to, const Obstacles& obstacles, double clearance);

/// Smallest distance between two segments [m].
double distanceBetween(const Segment& first, const Segment& second);

}  // namespace sim2d
