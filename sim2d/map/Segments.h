#pragma once

#include <optional>

#include "sim2d/base/Types.h"

namespace sim2d {

using base::Vec2;

/// A straight piece of an outline [m]. The solid lies on its left.
struct Segment {
  Vec2 a = Vec2::Zero();
  Vec2 b = Vec2::Zero();
};

Vec2 closestOnSegment(const Segment& segment, const Vec2& point);
double distanceToSegment(const Segment& segment, const Vec2& point);  // [m]

/// The two share at least one point; ends count.
bool segmentsTouch(const Segment& first, const Segment& second);
/// The second, which starts where the first ends, runs straight back over it.
bool isSpike(const Segment& first, const Segment& second);

/// Distance [m] along the unit vector `direction` to the segment, widened by a nanometre at its
/// ends so that no ray slips between two neighbours. None behind the origin or for parallel lines.
std::optional<double> raySegmentHit(const Vec2& from, const Vec2& direction,
                                    const Segment& segment);

}  // namespace sim2d
