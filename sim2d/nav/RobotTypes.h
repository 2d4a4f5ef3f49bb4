#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/Body.h"

/// Robots that people have, with published figures. SI, radians, robot frame.
namespace sim2d {

/// A planar lidar as it is mounted, looking ahead.
struct RobotLidar {
  int beams = 360;
  double angleMin = 0.0, angleMax = 0.0;  // of the first and the last beam [rad]
  double range = 10.0;                    // [m]
  double rate = 10.0;                     // turns [1/s]
  double x = 0.0, y = 0.0;                // of the sensor [m]
  double height = 0.3;                    // of its plane above the floor [m]
  double noise = 0.01;                    // standard deviation of a distance [m]
};

struct RobotType {
  std::string name;   // in files: "turtlebot3_burger"
  std::string title;  // "TurtleBot 3 Burger"
  /// Limits are those that the robot's own navigation or safety keeps to, where they are published;
  /// what the drive could do beyond is in the source. Where no speed backwards is published it is
  /// that ahead.
  RobotBody body;
  double height = 0.5;  // of the body above the floor [m]
  std::optional<RobotLidar> lidar;
  std::string source;  // of the figures, and which of them are not confirmed
};

/// In the order in which they are offered; the first is the general one. Thread: any.
const std::vector<RobotType>& robotTypes();
/// Null when there is no such name.
const RobotType* findRobotType(const std::string& name);

}  // namespace sim2d
