#pragma once

#include <deque>
#include <vector>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

namespace sim2d::nav2 {

/// A scan as points in world frame.
struct PointCloud {
  Vec2 origin = Vec2::Zero();  // of the sensor [m]
  double time = 0.0;           // [s]
  std::vector<Vec2> points;    // [m]
};

/// The scans of one source of an obstacle layer (nav2_costmap_2d, observation_buffer.cpp). Beams of
/// `LaserScan::range` are ROS's infinite ones.
class ObservationBuffer {
 public:
  ObservationBuffer(const ObservationSource& source, double lidarHeight)
      : source_(source), lidarHeight_(lidarHeight) {}

  /// Each step: takes in a scan that is newer than the last one.
  void observe(const LaserScan& scan);
  /// The scans that count at a time, newest first.
  const std::deque<PointCloud>& clouds(double time);
  /// Whether the last scan came no longer ago than `expected_update_rate`.
  bool isCurrent(double time) const;
  void restartClock(double time) { lastTime_ = time; }

  const ObservationSource& source() const { return source_; }

 private:
  ObservationSource source_;
  double lidarHeight_;      // [m]
  double lastScan_ = -1.0;  // [s], stamp of the newest scan
  double lastTime_ = 0.0;   // [s], when it came, or of the start
  std::deque<PointCloud> clouds_;
};

}  // namespace sim2d::nav2
