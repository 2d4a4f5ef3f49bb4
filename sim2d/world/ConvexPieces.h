#pragma once

#include <vector>

#include "sim2d/map/Outlines.h"

namespace sim2d {

/// Cuts a simple counter-clockwise polygon into convex pieces with at most `mostCorners` (>= 3)
/// corners: ears are cut off until the rest is one.
std::vector<std::vector<Vec2>> convexPieces(std::vector<Vec2> polygon, std::size_t mostCorners);

}  // namespace sim2d
