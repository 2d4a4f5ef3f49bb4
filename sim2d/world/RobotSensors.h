#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sim2d/nav/Lidar.h"
#include "sim2d/nav/Localization.h"
#include "sim2d/nav/Odometry.h"
#include "sim2d/nav/PeopleDetector.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// As a frame has it.
RobotSenses::Scan shownScan(LaserScan scan);

/// What the robots of a world sense with, held into the world step by step. Draws depend on seed
/// and robot alone. Takes no memory once its buffers have grown.
class RobotSensors {
 public:
  explicit RobotSensors(const WorldModel& model);

  /// Each step from the first one on, before anybody decides. `scans`, by robot: who looks at them.
  void update(const FrozenWorld& world, const std::vector<ScanUse>& scans);

  /// It was put there, at rest: errors of odometry add up from here.
  void relocate(std::size_t robot, const Pose2& pose) {
    robots_[robot].odometry.reset(pose);
    robots_[robot].localizer.reset();
  }
  /// A global localisation begins with the next correction, where there is a localiser.
  void relocalize(std::size_t robot) { robots_[robot].localizer.relocalize(); }

  /// Errors are drawn by another seed from now on; people walk on with their legs as they do.
  void reseed(std::uint64_t seed);

  const Odometry& odometry(std::size_t robot) const { return robots_[robot].odometry; }
  const Localizer& localizer(std::size_t robot) const { return robots_[robot].localizer; }
  /// Its pose in the map, as it estimates it.
  Pose2 pose(std::size_t robot) const {
    return toParent(robots_[robot].localizer.mapToOdom(), robots_[robot].odometry.pose());
  }
  /// Whom it knows of: people, then other robots, by id.
  const std::vector<TrackedBody>& bodies(std::size_t robot) const {
    return robots_[robot].detector.bodies();
  }
  /// The last turn of its lidar; null: it has none, or has not turned yet.
  const LaserScan* scan(std::size_t robot) const {
    return robots_[robot].lidar ? robots_[robot].lidar->scan() : nullptr;
  }
  /// That turn was made in the last update.
  bool hasTurned(std::size_t robot) const { return robots_[robot].hasTurned; }
  /// The last turn of its lidar where nobody has looked at it so far, else null. Its scan can be
  /// made when these sensors are gone.
  const std::shared_ptr<const RobotSenses::LaterScan>& laterScan(std::size_t robot) const {
    return robots_[robot].laterScan;
  }

 private:
  struct Sensors {
    Odometry odometry;
    Localizer localizer;
    std::optional<Lidar> lidar;
    PeopleDetector detector;
    std::shared_ptr<const RobotSenses::LaterScan> laterScan;
    bool hasTurned = false;
  };
  void gatherBodies(const FrozenWorld& world);
  static std::shared_ptr<const RobotSenses::LaterScan> laterScanOf(
      const Lidar& lidar, std::shared_ptr<const std::vector<Footprint>> footprints);
  void updateLidar(Sensors& sensors, const SensedWorld& world, ScanUse use) const;
  void updateOdometry(Sensors& sensors, const RobotState& now, const FrozenWorld& world) const;

  std::vector<Sensors> robots_;
  std::shared_ptr<const std::vector<Footprint>> footprints_;  // by robot
  std::vector<SensedBody> bodies_;                            // of this step
  bool hasBegun_ = false;
};

}  // namespace sim2d
