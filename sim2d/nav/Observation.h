#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/map/NavigationMap.h"
#include "sim2d/map/Obstacles.h"
#include "sim2d/nav/Body.h"

/// Information that a robot has when it decides. World frame, SI, radians.
namespace sim2d {

/// One lidar scan: distances counter-clockwise from `angleMin`, in the sensor frame.
struct LaserScan {
  Pose2 sensor;                   // pose as estimated by the robot [m], [rad]
  double time = 0.0;              // [s]
  double angleMin = 0.0;          // [rad], of the first beam
  double angleIncrement = 0.0;    // [rad] between neighbours
  double range = 30.0;            // [m]; the distance of beams without a hit
  std::vector<double> distances;  // [m]
  Pose2 mapToOdom;                // of the robot at this time; see `Observation`

  /// Direction of a beam in the frame of `sensor.position` [rad], not wrapped.
  double angle(std::size_t beam) const {
    return sensor.heading + angleMin + static_cast<double>(beam) * angleIncrement;
  }
};

enum class BodyKind : std::uint8_t { Person, Robot };

/// A body that the robot perceives: by its detector, or as ground truth.
struct TrackedBody {
  int id = 0;  // track id; the detector may swap ids
  BodyKind kind = BodyKind::Person;
  Vec2 position = Vec2::Zero();  // [m]
  Vec2 velocity = Vec2::Zero();  // [m/s]
  double heading = 0.0;          // [rad]
  double radius = 0.35;          // [m]
};

/// A dock of the scenario: the pose of a robot that has docked nose first.
struct DockPose {
  std::string name;
  Pose2 pose;  // [m], [rad]
  bool isCharging = true;
};

/// Perception of the robot at the start of the step. Pointers are valid during the call only.
struct Observation {
  Pose2 pose;                                 // in the map, as the robot estimates it
  BodyTwist motion;                           // from odometry
  Vec2 goal = Vec2::Zero();                   // current goal [m]
  std::vector<Vec2> remainingGoals;           // subsequent goals, in order [m]
  int externalGoalCount = 0;                  // number of goals set from outside; each is a new one
  double goalRadius = 0.2;                    // a goal is reached when the centre is inside [m]
  double time = 0.0, dt = 0.05;               // [s]
  std::vector<TrackedBody> bodies;            // people, then other robots, sorted by id
  std::optional<BatteryState> battery;        // none: unlimited power
  std::vector<DockPose> docks;                // docks that its dock detector sees, by odometry
  std::optional<BodyTwist> teleop;            // command of a user, for assisted teleoperation
  const LaserScan* scan = nullptr;            // null: no lidar, or no scan yet
  const Obstacles* obstacles = nullptr;       // walls of the known map; never null
  const NavigationMap* navigation = nullptr;  // routing over them; never null
  Pose2 mapToOdom;                            // of the localiser: pose of the frame odom in the map
  bool isLocalized = true;                    // false: no correction has been made yet
  bool canRelocalize = false;                 // the localiser makes further corrections
  /// Frame of all poses here, in the map: identity unless they were converted.
  Pose2 frame;
};

/// Input of a robot's sensors: the true world. World frame, SI, radians.

/// True state of a body. A robot may have a polygon footprint enclosed by `radius`; null: a disc.
struct SensedBody {
  int id = 0;  // unique within its kind
  BodyKind kind = BodyKind::Person;
  Vec2 position = Vec2::Zero();  // [m]
  double heading = 0.0;          // [rad]
  Vec2 velocity = Vec2::Zero();  // [m/s]
  double radius = 0.35;          // [m]
  const Footprint* footprint = nullptr;

  Pose2 pose() const { return {position, heading}; }
};

/// State at one step. `obstacles` is the same object at every step and is not rebuilt; its parts
/// may be switched. `bodies`: people sorted by id, then robots sorted by id, possibly including the
/// robot itself.
struct SensedWorld {
  Pose2 pose;      // true pose of the robot
  Pose2 odometry;  // estimated pose in the map
  const Obstacles& obstacles;
  const std::vector<SensedBody>& bodies;
  double time = 0.0;  // [s], >= 0, nondecreasing
  Pose2 mapToOdom{};  // of the robot's localiser
};

/// Index of the last event at or before `time` [s], for events at 0, 1/rate, 2/rate … (rate [Hz]),
/// with a tolerance of 1e-6 periods for rounded times.
inline std::int64_t eventIndexAt(double time, double rate) {
  return static_cast<std::int64_t>(std::floor(time * rate + 1e-6));
}

/// True if `point` lies within `range` and within `halfAngle` of the heading, and no obstacle is in
/// between.
inline bool isInView(const Pose2& eye, const Vec2& point, double range, double halfAngle,
                     const Obstacles& obstacles) {
  const Vec2 sight = point - eye.position;
  if (sight.norm() > range) {
    return false;
  }
  const double bearing = base::angleDiff(base::headingOf(sight), eye.heading);
  return std::fabs(bearing) <= halfAngle && obstacles.isVisible(eye.position, point);
}

}  // namespace sim2d
