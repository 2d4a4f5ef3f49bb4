#include "sim2d/nav/nav2/global/PathEnds.h"

#include <cmath>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {

void faceAlongPath(Path& path, double startHeading) {
  if (path.empty()) {
    return;
  }
  if (path.size() == 1) {
    path.back().heading = startHeading;
    return;
  }
  constexpr double kSame = 1e-4;  // [m]
  const Vec2 last = path.back().position;
  Vec2 before = path[path.size() - 2].position;
  if ((last - before).cwiseAbs().maxCoeff() < kSame && path.size() > 2) {
    before = path[path.size() - 3].position;
  }
  path.back().heading = base::atan2(last.y() - before.y(), last.x() - before.x());
}

Pose2 poseOnTheSpot(const Pose2& start, const Pose2& goal, bool useFinalApproachOrientation) {
  return {start.position, useFinalApproachOrientation ? start.heading : goal.heading};
}

}  // namespace sim2d::nav2
