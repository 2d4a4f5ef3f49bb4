#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

namespace sim2d::nav2 {

/// The decay of costs around lethal cells (nav2_costmap_2d, inflation_layer.hpp, computeCost).
struct InflationCostFunction {
  double radius = 0.55;    // maximum distance [m]
  double scaling = 10.0;   // cost_scaling_factor [1/m]
  double inscribed = 0.1;  // r_in of the robot [m]

  /// Cost at a distance between cell centres [m]: 254 at 0, 253 up to r_in, then trunc(252
  /// exp(-scaling (d - r_in))), also beyond `radius`.
  std::uint8_t cost(double distance) const;
  /// The inverse, as in MPPI's ObstaclesCritic and Regulated Pure Pursuit: r_in - ln(cost / 253) /
  /// scaling for costs in [1, 253] [m]; measured from the robot's centre.
  double distance(std::uint8_t cost) const;
};

/// Costs around lethal cells (nav2_costmap_2d::InflationLayer). Humble and Jazzy spread over the
/// four neighbours in order of distance, so a cell occasionally takes a source that is not quite
/// the nearest; main uses the exact distance, in steps of 1/100 cell.
class InflationLayer : public CostmapLayer {
 public:
  InflationLayer(std::string name, const CostmapContext& context,
                 const InflationLayerParameters& parameters, double resolution);

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& master, const CellWindow& window) override;
  void reset(double time) override;
  bool isCurrent() const override { return isCurrent_; }

  const InflationCostFunction& costFunction() const { return costFunction_; }

 private:
  struct InflationCell {  // a cell and the lethal cell from which its cost is computed
    Cell cell, source;
  };
  bool isSource(std::uint8_t cost) const;
  std::uint8_t raisedCost(std::uint8_t old, std::uint8_t cost) const;
  void inflateBySpreading(Costmap& master, const CellWindow& window, const CellWindow& wide);
  void resetSeen(const Costmap& master);
  std::size_t seenIndex(Cell cell) const {
    return static_cast<std::size_t>(cell.row + 1) * seenWidth_ +
           static_cast<std::size_t>(cell.column + 1);
  }
  void enqueue(const InflationCell& spread, std::size_t bin);
  template <class Square>
  void inflateExactly(Costmap& master, const CellWindow& window, const CellWindow& wide,
                      std::vector<Square>& across);
  template <class Square>
  void findRowDistances(const Costmap& master, const CellWindow& window, const CellWindow& wide,
                        std::vector<Square>& across) const;

  InflationLayerParameters parameters_;
  InflationCostFunction costFunction_;
  int radius_ = 0;  // [cells]
  bool needsFullUpdate_ = true, isCurrent_ = true;
  CostmapBounds last_;
  std::vector<std::uint8_t> costs_;               // by squared distance [cells²], up to radius_²
  std::vector<std::vector<InflationCell>> bins_;  // by squared distance; empty between updates
  std::vector<char> seen_;                        // cells, plus a border of one marked cell
  std::size_t seenWidth_ = 0;
  std::vector<std::int16_t> rowDistances_;       // squared distances along rows [cells²]
  std::vector<std::int32_t> rowDistancesLarge_;  // the same for a large radius
};

/// Nav2's inflation layer until Kilted, available in every branch
/// (nav2_costmap_2d::LegacyInflationLayer, which exists since Lyrical).
class LegacyInflationLayer final : private CostmapContext, public InflationLayer {
 public:
  LegacyInflationLayer(std::string name, const CostmapContext& context,
                       const LegacyInflationLayerParameters& parameters, double resolution);
};

/// Inflation costs that decay with `cost_scaling_factor_left` to the left of the robot's path and
/// with `cost_scaling_factor_right` to the right of it, so that a robot in a corridor keeps to the
/// side of the greater factor (nav2_costmap_2d::AsymmetricInflationLayer).
///
/// A lethal cell is to the left of the path when it lies to the left of the line through the
/// nearest pose and the next. Without a path, and when the robot is nearer to its end than
/// `goal_distance_threshold`, both sides decay with the greater factor. Nav2 had published only the
/// keys of this layer when it was implemented; the handling of these two cases is an interpretation
/// of the keys.
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

  /// The cost function with the mean of the two factors, for planners and controllers that estimate
  /// distances from costs.
  InflationCostFunction costFunction() const;

 private:
  bool isLeft(const Vec2& place) const;
  bool isSource(std::uint8_t cost) const;
  void removeOtherSide(const Costmap& master, Costmap& left, Costmap& right) const;

  AsymmetricInflationLayerParameters parameters_;
  InflationLayer left_, right_, both_;
  Path plan_;                  // latest path
  bool isAsymmetric_ = false;  // the sides have different factors in this update
  bool isNew_ = false;         // the path has changed since the last update
  bool isCurrent_ = true;
};

}  // namespace sim2d::nav2
