#pragma once

#include "sim2d/nav/nav2/Costmap.h"

namespace sim2d::nav2 {

/// `use_final_approach_orientation`: the last heading becomes that of the last piece of the path,
/// of the one before where that has no length; a single pose gets the start's heading.
void faceAlongPath(Path& path, double startHeading);

/// The one pose of a path from a place to itself.
Pose2 poseOnTheSpot(const Pose2& start, const Pose2& goal, bool useFinalApproachOrientation);

}  // namespace sim2d::nav2
