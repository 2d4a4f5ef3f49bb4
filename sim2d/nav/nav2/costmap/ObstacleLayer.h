#pragma once

#include <deque>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

namespace sim2d::nav2 {

/// A scan as points in the world frame.
struct PointCloud {
  Vec2 origin = Vec2::Zero();  // sensor position [m]
  double time = 0.0;           // [s]
  std::vector<Vec2> points;    // [m]
};

/// The scans of one source of an obstacle layer (nav2_costmap_2d, observation_buffer.cpp).
/// Distances of `LaserScan::range` correspond to ROS's infinite ones.
class ObservationBuffer {
 public:
  ObservationBuffer(const ObservationSource& source, double lidarHeight)
      : source_(source), lidarHeight_(lidarHeight) {}

  /// Called each step: stores the scan if it is newer than the last one.
  void observe(const LaserScan& scan);
  /// The scans that are valid at a time, newest first.
  const std::deque<PointCloud>& clouds(double time);
  /// Whether the last scan is no older than `expected_update_rate`.
  bool isCurrent(double time) const;
  void resetLastUpdated(double time) { lastTime_ = time; }

  const ObservationSource& source() const { return source_; }

 private:
  ObservationSource source_;
  double lidarHeight_;      // [m]
  double lastScan_ = -1.0;  // [s], stamp of the newest scan
  double lastTime_ = 0.0;   // [s], of the newest scan or the start
  std::deque<PointCloud> clouds_;
};

/// Obstacles seen by the lidar (nav2_costmap_2d::ObstacleLayer): a grid in which hits stay until a
/// ray passes through them. A voxel layer differs in that rays end two cells before the hit, and
/// that it has no effect when the lidar is outside its heights.
class ObstacleLayer final : public CostmapLayer {
 public:
  /// `master`: size and origin of the costmap.
  ObstacleLayer(std::string name, const CostmapContext& context,
                const ObstacleLayerParameters& parameters, const Costmap& master);
  ObstacleLayer(std::string name, const CostmapContext& context,
                const VoxelLayerParameters& parameters, const Costmap& master);

  void observe(const Observation& observation) override;
  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& master, const CellWindow& window) override;
  void reset(double time) override;
  bool isCurrent() const override { return isCurrent_ || !parameters_.enabled; }
  bool isClearable() const override { return true; }
  void clearArea(const Vec2& low, const Vec2& high, bool isInverted) override;
  const Costmap* grid() const override { return &grid_; }

 private:
  void clearRays(const PointCloud& cloud, const ObservationSource& source, CostmapBounds& bounds);
  void clearRay(Cell from, const Vec2& origin, const Vec2& end, const ObservationSource& source,
                CostmapBounds& bounds);
  void mark(const PointCloud& cloud, const ObservationSource& source, CostmapBounds& bounds);
  Vec2 clippedEnd(const Vec2& origin, const Vec2& end) const;

  ObstacleLayerParameters parameters_;
  std::vector<ObservationBuffer> buffers_;
  double rayShortening_ = 0.0;  // length by which rays are shortened [m]
  bool marksObstacles_ = true;  // the lidar is within the heights of the layer
  bool isCurrent_ = true, wasReset_ = false;
  CostmapBounds extraBounds_;
  Polygon footprint_;  // in world frame; empty: clears nothing
  Costmap grid_;
};

}  // namespace sim2d::nav2
