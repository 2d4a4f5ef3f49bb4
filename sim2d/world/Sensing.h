#pragma once

#include <vector>

#include "sim2d/world/SocialForce.h"

namespace sim2d {

using SeenBody = Walker;

/// `point` lies within `range` and within `halfAngle` of the heading, and nothing solid is between.
bool isInView(const Pose2& eye, const Vec2& point, double range, double halfAngle,
              const Obstacles& obstacles);

/// A turn of a lidar: distances to the nearest wall or body, counter-clockwise from the heading.
struct Scan {
  double range = 30.0;            // [m]; beams without a hit have it
  std::vector<double> distances;  // [m]
};
Scan scan(const Pose2& sensor, const Obstacles& obstacles, const std::vector<SeenBody>& bodies,
          int beamCount = 360, double range = 30.0);

}  // namespace sim2d
