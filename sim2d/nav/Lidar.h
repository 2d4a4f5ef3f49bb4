#pragma once

#include <cstdint>
#include <vector>

#include "sim2d/nav/LegGait.h"
#include "sim2d/nav/LidarRaster.h"
#include "sim2d/nav/SensedWorld.h"

/// A planar lidar on a robot.
namespace sim2d {

struct LidarParameters {
  int beams = 360;               // >= 1
  double range = 30.0;           // [m] > 0
  double rate = 10.0;            // turns per second [Hz] > 0
  double angleMin = -base::kPi;  // [rad], of the first beam
  double angleMax = base::kPi;   // [rad], of the last one; more than angleMin, by a turn at most
  Pose2 mount;                   // in the robot's frame
  double noise = 0.0;            // standard deviation of a distance [m] >= 0
  bool legs = true;              // people are two legs, else the discs of their bodies
};

/// What a lidar asserts: the beams are 1e-4 rad apart at least and within a turn, range and rate
/// are above 0.
bool isPossible(const LidarParameters& parameters);

/// Beams stand evenly from angleMin to angleMax; over a whole turn the last one would be the first
/// again, so there they are a turn / beams apart. 1e-4 rad between neighbours at least. A turn is
/// taken at one instant. All beams of a sensor inside of a wall or body have the distance 0.
///
/// Each distance to something has its own Gaussian error, drawn by (seed, robot, number of the
/// turn, sensor, beam) and cut to [0, range]; beams that meet nothing have `range` without one.
/// Thread: one at a time. Allocates nothing after the first turn but for growing crowds and more
/// walls than before.
class Lidar {
 public:
  static constexpr double kWallMargin = 2.0;  // [m]

  /// `sensor` in [0, 1023]: which one of the robot's lidars.
  Lidar(const LidarParameters& parameters, std::uint64_t seed, int robotId, int sensor = 0);

  /// Each step. The n-th turn is due at n / rate and made at the first step not before that; of
  /// several that are due only the last is. Returns whether one was made. With `isRead` false legs
  /// walk on, but no turn is made: nobody would look at it. The turns after that are the same.
  bool update(const SensedWorld& world, bool isRead = true);
  /// Draws of further turns; legs walk on as they do.
  void reseed(std::uint64_t seed) { seed_ = seed; }
  /// The last turn that was made, stamped with the time of its step; null before the first.
  const LaserScan* scan() const { return scan_.distances.empty() ? nullptr : &scan_; }

 private:
  struct BeamFrame {  // origin in the sensor, x along the first beam
    Vec2 origin, ahead;
    Vec2 toFrame(const Vec2& place) const {
      const Vec2 offset = place - origin;
      return {ahead.dot(offset), base::cross(ahead, offset)};
    }
  };

  void makeTurn(const SensedWorld& world);
  void gatherWalls(const Obstacles& obstacles, const Vec2& from);
  void addWalls(const BeamFrame& frame);
  void addBodies(const std::vector<SensedBody>& bodies, const BeamFrame& frame);
  void addPerson(const SensedBody& person, double stride, const BeamFrame& frame);
  void addPolygon(const SensedBody& robot, const BeamFrame& frame);
  void addNoise();

  LidarParameters parameters_;
  std::uint64_t seed_;
  int robotId_;
  int sensor_;
  std::int64_t turn_ = -1;
  LaserScan scan_;
  LegGait gait_;
  LidarRaster raster_;

  std::vector<Segment> walls_;  // within range and margin of the place where they were gathered
  Vec2 wallsFrom_ = Vec2::Zero();
  std::vector<char> wallParts_;  // which were enabled then
};

}  // namespace sim2d
