#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim2d/nav/nav2/params/ParameterFile.h"

namespace sim2d::nav2 {

/// The TF frames that a parameter file names, without a leading '/'.
struct FrameNames {
  std::string map = "map";    // global_frame of the global costmap
  std::string odom = "odom";  // of the local costmap; of the behaviors if both costmaps agree
  /// Whether the local costmap has another global_frame than the global one: it moves with the
  /// odometry.
  bool isLocalInOdom = false;
  std::vector<std::string> onRobot;  // base frames and sensor frames, sorted

  /// Whether a transform between two frames exists: both are known, and a transform to or from the
  /// map requires that the robot is localized. Names may have a leading '/'.
  bool canTransform(std::string_view parent, std::string_view child, bool isLocalized) const;
};

/// Reads `global_frame` and `local_frame` of costmaps and behaviours, and `robot_base_frame`,
/// `base_frame_id`, `base_frame` and `sensor_frame` of all nodes. base_link and base_footprint are
/// always known.
FrameNames frameNamesOf(const ParameterFile& file, const std::string& robot);

}  // namespace sim2d::nav2
