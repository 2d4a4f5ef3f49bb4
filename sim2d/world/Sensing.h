#pragma once

#include <vector>

#include "sim2d/nav/SocialForce.h"

namespace sim2d {

using SeenBody = Walker;

/// A turn of a lidar: distances to the nearest wall or body, counter-clockwise from the heading.
struct Scan {
  double range = 30.0;            // [m]; beams without a hit have it
  std::vector<double> distances;  // [m]
};
Scan scan(const Pose2& sensor, const Obstacles& obstacles, const std::vector<SeenBody>& bodies,
          int beamCount = 360, double range = 30.0);

}  // namespace sim2d
