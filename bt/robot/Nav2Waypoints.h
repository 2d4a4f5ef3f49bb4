#pragma once

#include <optional>
#include <string>

#include "sim2d/base/Types.h"
#include "sim2d/nav/nav2/servers/WaypointTasks.h"

namespace bt {

/// The tasks of Nav2's waypoint_follower at the goals of a robot that drives to them one by one.
class Nav2Waypoints {
 public:
  /// `isWanted`: by the robot's planner parameter `waypoint_tasks`. Without a task in the file the
  /// robot drives on at once.
  Nav2Waypoints(const std::optional<sim2d::nav2::WaypointFollowerParameters>& follower,
                bool isWanted);

  /// Goals are driven to one by one, whatever tree the file has for several.
  bool isOn() const { return isWanted_; }
  /// The robot is at a goal: its task begins. A text: it has taken a photo, "x y heading".
  std::optional<std::string> reach(double time, const base::Pose2& pose);
  /// The task is still running.
  bool isBusy(double time) const { return time < busyUntil_; }

 private:
  sim2d::nav2::WaypointTaskParameters task_;
  bool isWanted_;
  double busyUntil_ = 0.0;  // [s]
};

}  // namespace bt
