#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sim2d/nav/Lidar.h"
#include "sim2d/nav/Localization.h"
#include "sim2d/nav/PeopleDetector.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Converts a scan to the type of frames.
RobotTelemetry::Scan toFrameScan(LaserScan scan);

/// Sensors of all robots of a world. Draws depend on seed and robot only. Does not allocate once
/// its buffers have grown.
class RobotSensors {
 public:
  explicit RobotSensors(const WorldModel& model);

  /// Call at each step before decisions, from the first step on. `scans`: use of the scan by robot.
  void update(const FrozenWorld& world, const std::vector<ScanDemand>& scans);

  /// Call after a teleport, at rest: odometry errors restart from here.
  void relocate(std::size_t robot, const Pose2& pose) {
    robots_[robot].odometry.reset(pose);
    robots_[robot].localizer.reset();
  }
  /// Starts a global localisation at the next correction, if there is a localiser.
  void relocalize(std::size_t robot) { robots_[robot].localizer.relocalize(); }

  /// Sets the seed of errors; the legs of people are not affected.
  void reseed(std::uint64_t seed);

  const Odometry& odometry(std::size_t robot) const { return robots_[robot].odometry; }
  const Localizer& localizer(std::size_t robot) const { return robots_[robot].localizer; }
  /// Estimated pose in the map.
  Pose2 pose(std::size_t robot) const {
    return toParent(robots_[robot].localizer.mapToOdom(), robots_[robot].odometry.pose());
  }
  /// Perceived bodies: people, then other robots, sorted by id.
  const std::vector<TrackedBody>& bodies(std::size_t robot) const {
    return robots_[robot].detector.bodies();
  }
  /// Last lidar scan; null: no lidar, or no scan yet.
  const LaserScan* scan(std::size_t robot) const {
    return robots_[robot].lidar ? robots_[robot].lidar->scan() : nullptr;
  }
  /// True if that scan was computed in the last update.
  bool hasTurned(std::size_t robot) const { return robots_[robot].hasTurned; }
  /// Last lidar scan if it is deferred and not computed yet; otherwise null. It remains usable
  /// after these sensors are destroyed.
  const std::shared_ptr<const RobotTelemetry::DeferredScan>& deferredScan(std::size_t robot) const {
    return robots_[robot].deferredScan;
  }

 private:
  struct Sensors {
    Odometry odometry;
    Localizer localizer;
    std::optional<Lidar> lidar;
    PeopleDetector detector;
    std::shared_ptr<const RobotTelemetry::DeferredScan> deferredScan;
    bool hasTurned = false;
  };
  void gatherBodies(const FrozenWorld& world);
  static std::shared_ptr<const RobotTelemetry::DeferredScan> deferredScanOf(
      const Lidar& lidar, std::shared_ptr<const std::vector<Footprint>> footprints);
  void updateLidar(Sensors& sensors, const SensedWorld& world, ScanDemand use) const;
  void updateOdometry(Sensors& sensors, const RobotState& now, const FrozenWorld& world) const;

  std::vector<Sensors> robots_;
  std::shared_ptr<const std::vector<Footprint>> footprints_;  // per robot
  std::vector<SensedBody> bodies_;                            // in this step
  bool hasBegun_ = false;
};

/// Batteries of robots and the docks that charge them.

/// A robot is at a dock when its centre is within this distance of the dock's pose and its heading,
/// or the opposite one of a robot that backs in, differs by less than the angle.
constexpr double kDockReach = 0.1;   // [m]
constexpr double kDockAngle = 0.35;  // [rad]
constexpr double kDockSight = 3.0;   // [m], range of the dock detector

/// The dock at which a robot with this pose is; null: none.
const Dock* dockAt(const std::vector<const Dock*>& docks, const Pose2& pose);

/// Docks within kDockSight of the robot, as its detector sees them: relative to its true pose,
/// converted to the frame in which the robot is at `believed`.
std::vector<DockPose> detectedDocks(const std::vector<const Dock*>& docks, const Pose2& truth,
                                    const Pose2& believed);

/// Measurement of the robot's battery monitor; none: no battery.
std::optional<BatteryState> measuredBattery(const ResolvedRobot& robot, const RobotState& state);

/// Call after the motion step: discharges batteries by the motion, or charges them at docks. Emits
/// `battery` with "charging", "full" or "empty" at the transition.
void updateBatteries(const WorldModel& model, WorldState& state);

}  // namespace sim2d
