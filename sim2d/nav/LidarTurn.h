#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "sim2d/nav/LidarRaster.h"
#include "sim2d/nav/SensedWorld.h"

/// A turn of a planar lidar: what stands around it, and what its beams then meet.
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

/// The instant of a turn: its scan can be made from it at any later time. World frame.
struct LidarTurn {
  std::int64_t number = -1;
  std::uint64_t seed = 0;
  double time = 0.0;                                  // [s]
  Pose2 sensor;                                       // where the robot takes its sensor to be
  Pose2 mapToOdom;                                    // of the robot
  Vec2 origin = Vec2::Zero();                         // where it is
  Vec2 ahead{1.0, 0.0};                               // along the first beam
  bool isInsideObstacle = false;                      // then all beams have the distance 0
  std::shared_ptr<const std::vector<Segment>> walls;  // not null; all within range
  std::vector<SensedBody> bodies;
  std::vector<double> strides;  // of the bodies, in [0, 1); empty: people are discs
};

/// Makes the scans of a lidar's turns. Thread: any, one waits for the other. Allocates nothing
/// after the first.
class LidarCaster {
 public:
  /// `sensor` in [0, 1023]: which one of the robot's lidars.
  LidarCaster(const LidarParameters& parameters, int robotId, int sensor);

  void cast(const LidarTurn& turn, LaserScan& scan);

 private:
  void addBodies(const LidarTurn& turn);
  void addPerson(const LidarTurn& turn, std::size_t number);
  void addPolygon(const LidarTurn& turn, const SensedBody& robot);
  void addNoise(const LidarTurn& turn, std::vector<double>& distances) const;

  LidarParameters parameters_;
  int robotId_;
  int sensor_;
  std::mutex mutex_;  // of the raster
  LidarRaster raster_;
};

}  // namespace sim2d
