#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim2d/nav/nav2/params/ParameterFile.h"

namespace sim2d::nav2 {

/// The frames of TF that a parameter file names, without a leading '/'.
struct FrameNames {
  std::string map = "map";    // global_frame of the global costmap
  std::string odom = "odom";  // that of the local costmap, or where both have one of the behaviours
  /// The local costmap has another global_frame than the global one: it moves with the odometry.
  bool isLocalInOdom = false;
  std::vector<std::string> onRobot;  // its base frames and those of its sensors, sorted

  /// Whether a transform between two frames exists: both are known, and a transform to or from the
  /// map needs a pose of the robot in the map. Names may have a leading '/'.
  bool canTransform(std::string_view parent, std::string_view child, bool isLocalized) const;
};

/// Read from `global_frame` and `local_frame` of costmaps and behaviours, and from
/// `robot_base_frame`, `base_frame_id`, `base_frame` and `sensor_frame` of all nodes. base_link and
/// base_footprint are always there.
FrameNames frameNamesOf(const ParameterFile& file, const std::string& robot);

}  // namespace sim2d::nav2
