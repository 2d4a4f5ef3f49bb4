#pragma once

#include <string>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
#include "sim2d/nav/nav2/costmap/InflationLayer.h"

namespace sim2d::nav2 {

/// The inflation layer of Nav2 until Kilted, in every branch
/// (nav2_costmap_2d::LegacyInflationLayer, which exists since Lyrical).
class LegacyInflationLayer final : private CostmapContext, public InflationLayer {
 public:
  LegacyInflationLayer(std::string name, const CostmapContext& context,
                       const LegacyInflationLayerParameters& parameters, double resolution);
};

/// Costs round obstacles that fall off by `cost_scaling_factor_left` to the left of the robot's
/// path and by `cost_scaling_factor_right` to the right of it, so that a robot in a corridor keeps
/// to the side of the greater factor (nav2_costmap_2d::AsymmetricInflationLayer).
///
/// A lethal cell is to the left of the path when it lies to the left of the line through the
/// nearest pose and the next. Without a path, and when the robot is nearer to its end than
/// `goal_distance_threshold`, both sides fall off with the greater factor. Only the keys of Nav2's
/// layer are published where this was written; how it treats these two cases is our reading of
/// them.
class AsymmetricInflationLayer final : public CostmapLayer {
 public:
  AsymmetricInflationLayer(const std::string& name, const CostmapContext& context,
                           const AsymmetricInflationLayerParameters& parameters, double resolution);

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& master, const CellWindow& window) override;
  void reset(double time) override;
  bool isCurrent() const override { return isCurrent_; }
  void setPlan(const Path& plan) override;

  /// With the mean of the two factors, for planners and controllers that estimate distances by
  /// costs.
  InflationLaw law() const;

 private:
  bool isLeft(const Vec2& place) const;
  bool isSource(std::uint8_t cost) const;
  void removeOtherSide(const Costmap& master, Costmap& left, Costmap& right) const;

  AsymmetricInflationLayerParameters parameters_;
  InflationLayer left_, right_, both_;
  Path plan_;             // the latest one
  bool isSided_ = false;  // the sides have different factors in this update
  bool isNew_ = false;    // sides have changed since the last update
  bool isCurrent_ = true;
};

}  // namespace sim2d::nav2
