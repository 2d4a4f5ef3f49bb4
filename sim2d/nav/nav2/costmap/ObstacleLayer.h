#pragma once

#include <string>
#include <vector>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
#include "sim2d/nav/nav2/costmap/ObservationBuffer.h"

namespace sim2d::nav2 {

/// What the lidar has seen (nav2_costmap_2d::ObstacleLayer): a grid of its own in which hits stay
/// until a ray passes. A voxel layer is the same with rays that end two cells before the hit, and
/// nothing when the lidar is not in its heights.
class ObstacleLayer final : public CostmapLayer {
 public:
  /// `master`: size and place of the costmap.
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
  void clearAlong(const PointCloud& cloud, const ObservationSource& source, CostmapBounds& bounds);
  void clearRay(Cell from, const Vec2& origin, const Vec2& end, const ObservationSource& source,
                CostmapBounds& bounds);
  void mark(const PointCloud& cloud, const ObservationSource& source, CostmapBounds& bounds);
  Vec2 clippedEnd(const Vec2& origin, const Vec2& end) const;

  ObstacleLayerParameters parameters_;
  std::vector<ObservationBuffer> buffers_;
  double shortened_ = 0.0;  // rays end that far before their hit [m]
  bool hasMarks_ = true;    // the lidar is in the heights of the layer
  bool isCurrent_ = true, wasReset_ = false;
  CostmapBounds extra_;
  Polygon footprint_;  // at the robot's place; empty: it clears nothing
  Costmap grid_;
};

}  // namespace sim2d::nav2
