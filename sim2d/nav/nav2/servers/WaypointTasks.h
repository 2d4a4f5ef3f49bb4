#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

/// Tasks of waypoint_follower (nav2_waypoint_follower), executed at each goal of a robot.
namespace sim2d::nav2 {

enum class WaypointTask : std::uint8_t { None, Wait, Photo, Input };

struct WaypointTaskParameters {
  WaypointTask kind = WaypointTask::None;
  bool enabled = true;
  int pauseDuration = 0;       // Wait [ms]
  double inputTimeout = 10.0;  // Input [s]
};

struct WaypointFollowerParameters {
  std::string taskPlugin = "wait_at_waypoint";
  WaypointTaskParameters task;  // parameters of that plugin
};

const std::vector<Nav2Key<WaypointFollowerParameters>>& waypointFollowerKeys();
const std::vector<IgnoredKey>& ignoredWaypointFollowerKeys();
const std::vector<Nav2Key<WaypointTaskParameters>>& waypointTaskKeys(WaypointTask task);
const std::vector<IgnoredKey>& ignoredWaypointTaskKeys();

/// Duration of a task at a goal [s]. There is no input source, so Input lasts until its timeout.
double waypointTaskDuration(const WaypointTaskParameters& task);

}  // namespace sim2d::nav2
