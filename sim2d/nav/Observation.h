#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/map/NavigationMap.h"
#include "sim2d/nav/Battery.h"
#include "sim2d/nav/Body.h"

/// What a robot knows when it decides. World frame, SI, radians.
namespace sim2d {

/// One turn of a lidar: distances counter-clockwise from `angleMin`, in the sensor's frame.
struct LaserScan {
  Pose2 sensor;                   // where the robot takes its sensor to be [m], [rad]
  double time = 0.0;              // [s]
  double angleMin = 0.0;          // [rad], of the first beam
  double perBeam = 0.0;           // [rad] between neighbours
  double range = 30.0;            // [m]; beams without a hit have it
  std::vector<double> distances;  // [m]
  Pose2 mapToOdom;                // of the robot at this time, see `Observation`
};

enum class BodyKind : std::uint8_t { Person, Robot };

/// Somebody the robot knows of: by its detector, or as it is (ground truth).
struct TrackedBody {
  int id = 0;  // of the track; the detector may swap them
  BodyKind kind = BodyKind::Person;
  Vec2 position = Vec2::Zero();  // [m]
  Vec2 velocity = Vec2::Zero();  // [m/s]
  double heading = 0.0;          // [rad]
  double radius = 0.35;          // [m]
};

/// A dock of the scenario: the pose of a robot that has driven in with its nose first.
struct DockPlace {
  std::string name;
  Pose2 pose;  // [m], [rad]
  bool isCharging = true;
};

/// The world as it was when the step began, as far as the robot's sensors tell. Pointers are valid
/// during the call.
struct Observation {
  Pose2 pose;                                 // in the map, as the robot estimates it
  BodyTwist motion;                           // own, by odometry
  Vec2 goal = Vec2::Zero();                   // the current one [m]
  std::vector<Vec2> goalsAfter;               // those that follow it, in order [m]
  int orders = 0;                             // goals from outside so far: each is a new one
  double goalRadius = 0.2;                    // arrived = centre inside [m]
  double time = 0.0, dt = 0.05;               // [s]
  std::vector<TrackedBody> bodies;            // people, then other robots, by id
  std::optional<BatteryState> battery;        // none: it never runs low
  std::vector<DockPlace> docks;               // those that its dock detector sees, by odometry
  std::optional<BodyTwist> teleop;            // command of a person, for assisted teleoperation
  const LaserScan* scan = nullptr;            // null: no lidar, or not turned yet
  const Obstacles* obstacles = nullptr;       // walls of the known map; never null
  const NavigationMap* navigation = nullptr;  // routes over them; never null
  Pose2 mapToOdom;                            // of the localiser: the frame odom in the map
  bool isLocalized = true;                    // false: no correction has come yet
  bool canRelocalize = false;                 // there is a localiser that corrects again
  /// The frame of all poses here, in the map: an identity, unless they were converted.
  Pose2 frame;
};

}  // namespace sim2d
