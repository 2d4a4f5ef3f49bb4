#pragma once

#include <optional>
#include <vector>

#include "sim2d/map/NavigationMap.h"

namespace sim2d {

/// A body that stands in the way.
struct StandingBody {
  Vec2 position = Vec2::Zero();
  double radius = 0.35;  // [m]
};

/// A place beside those who stand on the line from `from` to `next`, to be passed first: planned
/// ways know walls alone. The shortest one that a body of this radius can walk to and on from;
/// nothing when nobody stands there or there is no room.
std::optional<Vec2> placeBeside(const std::vector<StandingBody>& standing, double radius,
                                const Vec2& from, const Vec2& next,
                                const NavigationMap& navigation);

}  // namespace sim2d
