#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim2d/nav/LegGait.h"
#include "sim2d/nav/LidarTurn.h"

/// A planar lidar on a robot.
namespace sim2d {

/// Whether somebody looks at a scan: `Later` is for who may do so after the step, or never.
enum class ScanUse : std::uint8_t { None, Later, Now };

/// Beams stand evenly from angleMin to angleMax; over a whole turn the last one would be the first
/// again, so there they are a turn / beams apart. 1e-4 rad between neighbours at least. A turn is
/// taken at one instant. All beams of a sensor inside of a wall or body have the distance 0.
///
/// Each distance to something has its own Gaussian error, drawn by (seed, robot, number of the
/// turn, sensor, beam) and cut to [0, range]; beams that meet nothing have `range` without one.
/// Thread: one at a time. Allocates nothing after the first turn but for growing crowds, more walls
/// than before, and turns that are looked at later.
class Lidar {
 public:
  static constexpr double kWallMargin = 2.0;  // [m]

  /// `sensor` in [0, 1023]: which one of the robot's lidars.
  Lidar(const LidarParameters& parameters, std::uint64_t seed, int robotId, int sensor = 0);
  ~Lidar() = default;
  Lidar(const Lidar&) = delete;  // it shares with its turns, and with nobody else
  Lidar& operator=(const Lidar&) = delete;
  Lidar(Lidar&&) = default;
  Lidar& operator=(Lidar&&) = default;

  /// Each step. The n-th turn is due at n / rate and made at the first step not before that; of
  /// several that are due only the last is. Returns whether this step's was. A turn for later is
  /// made when somebody wants it now after all. Without use legs walk on, but no turn is made:
  /// nobody would look at it. The turns after that are the same.
  bool update(const SensedWorld& world, ScanUse use = ScanUse::Now);
  /// Draws of further turns; legs walk on as they do.
  void reseed(std::uint64_t seed) { seed_ = seed; }
  /// The last turn that was made, stamped with the time of its step; null before the first.
  const LaserScan* scan() const { return scan_.distances.empty() ? nullptr : &scan_; }
  /// The last turn, where it is for later and has not been made; else null. Footprints of its
  /// bodies are those of the world that it was taken of.
  const std::shared_ptr<const LidarTurn>& laterTurn() const { return laterTurn_; }
  const std::shared_ptr<LidarCaster>& caster() const { return caster_; }

 private:
  void take(const SensedWorld& world, LidarTurn& turn);
  void gatherWalls(const Obstacles& obstacles, const Vec2& from);

  LidarParameters parameters_;
  std::uint64_t seed_;
  std::int64_t number_ = -1;  // of the last turn
  LegGait gait_;
  std::shared_ptr<LidarCaster> caster_;
  LidarTurn turn_;  // its memory is used again
  LaserScan scan_;
  std::shared_ptr<const LidarTurn> laterTurn_;

  /// Within range and margin of the place where they were gathered.
  std::shared_ptr<std::vector<Segment>> walls_;
  bool areWallsShared_ = false;  // with turns for later
  Vec2 wallsFrom_ = Vec2::Zero();
  std::vector<char> wallParts_;  // which were enabled then
};

}  // namespace sim2d
