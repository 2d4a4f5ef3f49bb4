#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/Body.h"

/// Commercial robots with published figures. SI, radians, robot frame.
namespace sim2d {

/// A planar lidar and its mounting; it faces forward.
struct RobotLidar {
  int beams = 360;
  double angleMin = 0.0, angleMax = 0.0;  // first and last beam [rad]
  double range = 10.0;                    // [m]
  double rate = 10.0;                     // scans per second [1/s]
  double x = 0.0, y = 0.0;                // position of the sensor [m]
  double height = 0.3;                    // of the scan plane above the floor [m]
  double noise = 0.01;                    // standard deviation of a distance [m]
};

struct RobotType {
  std::string name;   // in files: "turtlebot3_burger"
  std::string title;  // "TurtleBot 3 Burger"
  /// Limits are those of the robot's own navigation or safety software where they are published;
  /// the limits of the drive itself are in `source`. If no reverse speed is published, it equals
  /// the forward speed.
  RobotBody body;
  double height = 0.5;  // of the body above the floor [m]
  std::optional<RobotLidar> lidar;
  std::string source;  // sources of the figures, and which are unverified
};

/// In display order; the first is the generic robot. Thread-safe.
const std::vector<RobotType>& robotTypes();
/// Null if no robot has that name.
const RobotType* findRobotType(const std::string& name);

}  // namespace sim2d
