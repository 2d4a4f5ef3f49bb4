#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
#include "sim2d/nav/nav2/costmap/ObstacleLayer.h"

namespace sim2d::nav2 {

/// Voxels with expiring marks (spatio_temporal_voxel_layer::SpatioTemporalVoxelLayer, S. Macenski,
/// D. Tsai, M. Feinberg: Spatio-temporal voxel layer, IJARS 2020), in two dimensions: one layer of
/// voxels, marked by the points of the lidar and never cleared by rays. A voxel of age t becomes
/// free when its remaining time, `voxel_decay` - t (linear) or `voxel_decay` exp(-t) (exponential),
/// is below 0. Within the field of view of a clearing source it also ages by `decay_acceleration`
/// t³ / 6 at each update, even if it is occluded.
class SpatioTemporalVoxelLayer final : public CostmapLayer {
 public:
  /// `master`: size and origin of the costmap.
  SpatioTemporalVoxelLayer(std::string name, const CostmapContext& context,
                           const SpatioTemporalVoxelLayerParameters& parameters,
                           const Costmap& master);

  void observe(const Observation& observation) override;
  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& master, const CellWindow& window) override;
  void reset(double time) override;
  bool isCurrent() const override { return isCurrent_ || !parameters_.enabled; }
  bool isClearable() const override { return true; }
  void clearArea(const Vec2& low, const Vec2& high, bool isInverted) override;
  const Costmap* grid() const override { return &grid_; }

  /// Number of marked voxels, including those outside the costmap.
  std::size_t voxels() const { return marks_.size(); }

 private:
  struct Sensor {
    SpatioTemporalVoxelSource source;
    ObservationBuffer buffer;
  };
  using Voxel = std::int64_t;  // column and row, 32 bits each
  Voxel voxelAt(const Vec2& place) const;
  Vec2 centreOf(Voxel voxel) const;
  bool isInView(const Sensor& sensor, const Vec2& place) const;
  bool hasDecayed(double& marked, const Vec2& place, double time) const;
  void mark(Sensor& sensor, double time);
  void updateGrid(CostmapBounds& bounds);

  SpatioTemporalVoxelLayerParameters parameters_;
  std::vector<Sensor> sensors_;
  std::unordered_map<Voxel, double> marks_;  // time of each mark [s]; in any order
  Pose2 lidar_;                              // pose at the newest scan
  bool hasScan_ = false;
  CostmapBounds drawnBounds_;  // bounds of the voxels at the last update
  bool isCurrent_ = true, wasReset_ = false;
  Polygon footprint_;  // in world frame; empty: clears nothing
  Costmap grid_;
};

}  // namespace sim2d::nav2
