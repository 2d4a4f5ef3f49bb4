#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim2d/base/Types.h"

/// Convex polygons, counter-clockwise, as things to walk round. World frame [m]. Thread: any.
namespace sim2d {

using base::Vec2;

/// The corners, without points on a straight edge.
std::vector<Vec2> convexHull(std::vector<Vec2> points);

/// Where a straight line comes into a convex polygon.
struct Entry {
  double share = 0.0;    // of the line, 0 to 1; 0: it begins inside
  std::size_t edge = 0;  // that it crosses, by its first corner; inside: the one that is nearest
};
/// None: the line passes by or only touches the border.
std::optional<Entry> entryInto(const std::vector<Vec2>& polygon, const Vec2& from, const Vec2& to);

/// The two shortest ways round a convex polygon, `from` and `to` included: with it on the right
/// hand (passing on the left of it), and on the left hand. Both empty when the straight line meets
/// it nowhere or when one of the ends is inside.
struct WaysRound {
  std::vector<Vec2> left, right;
};
WaysRound waysRound(const std::vector<Vec2>& polygon, const Vec2& from, const Vec2& to);

}  // namespace sim2d
