#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Types.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/servers/Behaviors.h"

namespace bt {

/// The goals of one run of a navigator tree: one, or all of a route through several. Goals that the
/// world counts as reached and goals that the tree has removed are tracked separately.
class Nav2GoalTracker {
 public:
  /// Starts a route from `from` to the goal and, with `isThrough`, on through `after`.
  void begin(const base::Pose2& from, const base::Vec2& goal, const std::vector<base::Vec2>& after,
             bool isThrough);
  /// Whether the world's remaining goals are the end of this route; otherwise a new run starts.
  bool continuesTo(const base::Vec2& goal, const std::vector<base::Vec2>& after);
  bool isEmpty() const { return poses_.empty(); }

  /// Scenario goals are points: each pose faces along the straight line from the previous one.
  const sim2d::nav2::Path& poses() const { return poses_; }
  /// Sets the number of goals left in the tree's list.
  void setGoalsLeftInTree(std::size_t count);
  /// Number of goals that the world still wants, including the current one; at least one.
  std::size_t left() const { return poses_.size() > reached_ ? poses_.size() - reached_ : 1; }
  /// Number of goals that the tree has passed and the world has not.
  std::size_t takePassed();

 private:
  sim2d::nav2::Path poses_;
  bool isThrough_ = false;
  std::size_t reached_ = 0, passed_ = 0;  // by the world, by the tree
};

/// The tasks of Nav2's waypoint_follower at the goals of a robot that visits them one by one.
class Nav2Waypoints {
 public:
  /// `isWanted`: planner parameter `waypoint_tasks` of the robot. Without a task in the file the
  /// robot continues immediately.
  Nav2Waypoints(const std::optional<sim2d::nav2::WaypointFollowerParameters>& follower,
                bool isWanted);

  /// Whether goals are visited one by one, regardless of the file's tree for several goals.
  bool isOn() const { return isWanted_; }
  /// Starts the task at a goal. Returns text if a photo is taken: "x y heading".
  std::optional<std::string> reach(double time, const base::Pose2& pose);
  /// Whether the task is still running.
  bool isBusy(double time) const { return time < busyUntil_; }

 private:
  sim2d::nav2::WaypointTaskParameters task_;
  bool isWanted_;
  double busyUntil_ = 0.0;  // [s]
};

}  // namespace bt
