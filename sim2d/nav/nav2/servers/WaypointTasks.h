#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/Nav2Key.h"

/// Tasks of waypoint_follower (nav2_waypoint_follower): what a robot does at each of its goals.
namespace sim2d::nav2 {

enum class WaypointTask : std::uint8_t { None, Wait, Photo, Input };

struct WaypointTaskParameters {
  WaypointTask kind = WaypointTask::None;
  bool enabled = true;
  int pauseDuration = 0;       // of Wait [ms]
  double inputTimeout = 10.0;  // of Input [s]
};

struct WaypointFollowerParameters {
  std::string taskPlugin = "wait_at_waypoint";
  WaypointTaskParameters task;  // of that plugin
};

const std::vector<Nav2Key<WaypointFollowerParameters>>& waypointFollowerKeys();
const std::vector<IdleKey>& idleWaypointFollowerKeys();
const std::vector<Nav2Key<WaypointTaskParameters>>& waypointTaskKeys(WaypointTask task);
const std::vector<IdleKey>& idleWaypointTaskKeys();

/// How long the robot stands at a goal for its task [s]. There is no input here: it is waited for
/// until its timeout.
double durationOf(const WaypointTaskParameters& task);

}  // namespace sim2d::nav2
