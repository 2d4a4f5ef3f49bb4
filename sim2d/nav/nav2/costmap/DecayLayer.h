#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
#include "sim2d/nav/nav2/costmap/ObservationBuffer.h"

namespace sim2d::nav2 {

/// Voxels that forget (spatio_temporal_voxel_layer::SpatioTemporalVoxelLayer, S. Macenski, D. Tsai,
/// M. Feinberg: Spatio-temporal voxel layer, IJARS 2020), in a plane: one layer of voxels, marked
/// by the points of the lidar and never cleared by rays. A voxel of age t is free when what is left
/// of its time, `voxel_decay` - t (linear) or `voxel_decay` exp(-t) (exponential), is below 0.
/// Within the field of view of a clearing source it also ages by `decay_acceleration` t³ / 6 at
/// each update, whether or not something lies in between.
class DecayLayer final : public CostmapLayer {
 public:
  /// `master`: size and place of the costmap.
  DecayLayer(std::string name, const CostmapContext& context,
             const DecayLayerParameters& parameters, const Costmap& master);

  void observe(const Observation& observation) override;
  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& master, const CellWindow& window) override;
  void reset(double time) override;
  bool isCurrent() const override { return isCurrent_ || !parameters_.enabled; }
  bool isClearable() const override { return true; }
  void clearArea(const Vec2& low, const Vec2& high, bool isInverted) override;
  const Costmap* grid() const override { return &grid_; }

  /// Of all marked voxels, on the costmap or not.
  std::size_t voxels() const { return marks_.size(); }

 private:
  struct Sensor {
    DecaySource source;
    ObservationBuffer buffer;
  };
  using Voxel = std::int64_t;  // column and row, each in 32 bits
  Voxel voxelAt(const Vec2& place) const;
  Vec2 centreOf(Voxel voxel) const;
  bool isInView(const Sensor& sensor, const Vec2& place) const;
  bool decays(double& marked, const Vec2& place, double time) const;
  void mark(Sensor& sensor, double time);
  void draw(CostmapBounds& bounds);

  DecayLayerParameters parameters_;
  std::vector<Sensor> sensors_;
  std::unordered_map<Voxel, double> marks_;  // when each was marked [s]; their order has no effect
  Pose2 lidar_;                              // at the newest scan
  bool hasScan_ = false;
  CostmapBounds drawn_;  // where voxels were at the last update
  bool isCurrent_ = true, wasReset_ = false;
  Polygon footprint_;  // at the robot's place; empty: it clears nothing
  Costmap grid_;
};

}  // namespace sim2d::nav2
