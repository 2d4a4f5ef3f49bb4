#include "bt/robot/Nav2Goals.h"

#include <algorithm>

#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"

namespace bt {

void Nav2GoalTracker::begin(const base::Pose2& from, const base::Vec2& goal,
                            const std::vector<base::Vec2>& after, bool isThrough) {
  isThrough_ = isThrough;
  reached_ = passed_ = 0;
  poses_.clear();
  base::Vec2 last = from.position;
  const auto add = [&](const base::Vec2& point) {
    const base::Vec2 way = point - last;
    poses_.push_back({point, base::atan2(way.y(), way.x())});
    last = point;
  };
  add(goal);
  if (isThrough) {
    std::for_each(after.begin(), after.end(), add);
  }
}

bool Nav2GoalTracker::continuesTo(const base::Vec2& goal, const std::vector<base::Vec2>& after) {
  const std::size_t wanted = isThrough_ ? after.size() + 1 : 1;
  if (wanted > poses_.size()) {
    return false;
  }
  const std::size_t first = poses_.size() - wanted;
  bool isSame = poses_[first].position == goal;
  for (std::size_t k = 1; k < wanted && isSame; ++k) {
    isSame = poses_[first + k].position == after[k - 1];
  }
  reached_ = isSame ? first : reached_;
  return isSame;
}

void Nav2GoalTracker::setGoalsLeftInTree(std::size_t count) {
  if (isThrough_ && count > 0 && count <= poses_.size()) {
    passed_ = std::max(passed_, poses_.size() - count);
  }
}

std::size_t Nav2GoalTracker::takePassed() {
  const std::size_t more = passed_ > reached_ ? passed_ - reached_ : 0;
  reached_ += more;
  return more;
}

namespace {

constexpr double kTick = 1e-9;  // [s], tolerance for sums of steps

}  // namespace

Nav2Waypoints::Nav2Waypoints(const std::optional<sim2d::nav2::WaypointFollowerParameters>& follower,
                             bool isWanted)
    : isWanted_(isWanted) {
  if (follower) {
    task_ = follower->task;
  }
}

std::optional<std::string> Nav2Waypoints::reach(double time, const base::Pose2& pose) {
  busyUntil_ = time + sim2d::nav2::waypointTaskDuration(task_) - kTick;
  if (!task_.enabled || task_.kind != sim2d::nav2::WaypointTask::Photo) {
    return std::nullopt;
  }
  return base::formatDecimals(pose.position.x(), 2) + " " +
         base::formatDecimals(pose.position.y(), 2) + " " + base::formatDecimals(pose.heading, 2);
}

}  // namespace bt
