#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "sim2d/map/Obstacles.h"
#include "sim2d/nav/Observation.h"

/// What the sensors of a robot are held into: the world as it is. World frame, SI, radians.
namespace sim2d {

/// Somebody as he is. A robot may have a polygon as its footprint, which `radius` then encloses;
/// null: a disc.
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

/// One step. `obstacles` are the same object at every step and not built anew; their parts may be
/// switched. `bodies`: people by id, then robots by id; the robot itself may be among them.
struct SensedWorld {
  Pose2 pose;      // of the robot, true
  Pose2 odometry;  // where the robot takes itself to be, in the map
  const Obstacles& obstacles;
  const std::vector<SensedBody>& bodies;
  double time = 0.0;  // [s], >= 0, never less than before
  Pose2 mapToOdom{};  // of the robot's localiser
};

/// Number of the last event at or before `time` [s] of those at 0, 1/rate, 2/rate … (rate [Hz]);
/// a microperiod early counts, so that rounded times meet their event.
inline std::int64_t eventAt(double time, double rate) {
  return static_cast<std::int64_t>(std::floor(time * rate + 1e-6));
}

}  // namespace sim2d
