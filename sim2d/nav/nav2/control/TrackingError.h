#pragma once

#include <cstddef>

#include "sim2d/nav/nav2/Costmap.h"

namespace sim2d::nav2 {

/// How far a robot is off the path that it follows (nav2_msgs/TrackingFeedback of the controller
/// server, since Lyrical).
struct TrackingFeedback {
  int number = 0;               // cycles of the controller so far; 0: none yet
  double positionError = 0.0;   // distance to the path [m]; above 0: the robot is on its left
  double headingError = 0.0;    // from the robot's heading to the direction of the path [rad]
  std::size_t index = 0;        // pose of the path at which the nearest segment begins
  double distanceToGoal = 0.0;  // straight, to the end of the path [m]
  double remaining = 0.0;       // length of the path from the nearest point on [m]
};

/// The nearest segment of the path, looked for from the segment `first` on within `window` metres
/// of its length (negative: to the end). `number` is left at 0. The direction of a segment of two
/// equal poses is the heading of its first one. A path of one pose has that pose alone; an empty
/// path gives zeros.
TrackingFeedback trackingError(const Path& path, const Pose2& robot, std::size_t first,
                               double window);

}  // namespace sim2d::nav2
