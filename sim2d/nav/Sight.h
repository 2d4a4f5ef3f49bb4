#pragma once

#include "sim2d/map/Obstacles.h"

namespace sim2d {

/// `point` lies within `range` and within `halfAngle` of the heading, and nothing solid is between.
bool isInView(const Pose2& eye, const Vec2& point, double range, double halfAngle,
              const Obstacles& obstacles);

}  // namespace sim2d
