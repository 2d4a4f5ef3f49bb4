#pragma once

#include <cstddef>

#include "sim2d/nav/nav2/Costmap.h"

namespace sim2d::nav2 {

/// Deviation of a robot from its path (nav2_msgs/TrackingFeedback of the controller server, since
/// Lyrical).
struct TrackingFeedback {
  int number = 0;               // number of controller cycles; 0: none yet
  double positionError = 0.0;   // distance to the path [m]; positive: the robot is to its left
  double headingError = 0.0;    // from the robot's heading to the path direction [rad]
  std::size_t index = 0;        // pose at which the nearest segment begins
  double distanceToGoal = 0.0;  // Euclidean distance to the end of the path [m]
  double remaining = 0.0;       // path length from the nearest point [m]
};

/// Finds the nearest segment of the path, starting at segment `first`, within `window` metres of
/// path length (negative: to the end). Leaves `number` at 0. The direction of a segment of zero
/// length is the heading of its first pose. A path of one pose is compared with that pose; an empty
/// path gives zeros.
TrackingFeedback trackingError(const Path& path, const Pose2& robot, std::size_t first,
                               double window);

}  // namespace sim2d::nav2
