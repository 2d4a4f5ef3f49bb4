#include "bt/robot/Nav2Waypoints.h"

#include "sim2d/base/Text.h"

namespace bt {
namespace {

constexpr double kTick = 1e-9;  // [s], for sums of steps

}  // namespace

Nav2Waypoints::Nav2Waypoints(const std::optional<sim2d::nav2::WaypointFollowerParameters>& follower,
                             bool isWanted)
    : isWanted_(isWanted) {
  if (follower) {
    task_ = follower->task;
  }
}

std::optional<std::string> Nav2Waypoints::reach(double time, const base::Pose2& pose) {
  busyUntil_ = time + sim2d::nav2::durationOf(task_) - kTick;
  if (!task_.enabled || task_.kind != sim2d::nav2::WaypointTask::Photo) {
    return std::nullopt;
  }
  return base::formatDecimals(pose.position.x(), 2) + " " +
         base::formatDecimals(pose.position.y(), 2) + " " + base::formatDecimals(pose.heading, 2);
}

}  // namespace bt
