#pragma once

#include <optional>
#include <string>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

/// Costmap filters, which apply masks to the merged costs.
namespace sim2d::nav2 {

/// The mask raises costs (nav2_costmap_2d::KeepoutFilter): 100 becomes 254, unknown cells have no
/// effect.
class KeepoutFilter final : public CostmapLayer {
 public:
  KeepoutFilter(std::string name, const CostmapContext& context,
                const KeepoutFilterParameters& parameters, const OccupancyGrid& mask);

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& master, const CellWindow& window) override;
  void reset(double time) override;

 private:
  std::uint8_t maskCost(const Vec2& place) const;

  KeepoutFilterParameters parameters_;
  OccupancyGrid mask_;
  Pose2 frame_;  // of the costmap, in the map frame
  bool isNew_ = true;
  bool isOverridden_ = false, wasOverridden_ = false;  // the robot is in a zone and may leave it
};

/// The mask under the robot is a switch (nav2_costmap_2d::BinaryFilter): the state is
/// `default_state`, and the opposite where base + multiplier * value > `flip_threshold`. Off the
/// mask it returns to the default, over unknown cells it is kept. Does not change costs.
class BinaryFilter final : public CostmapLayer {
 public:
  BinaryFilter(std::string name, const CostmapContext& context,
               const BinaryFilterParameters& parameters, const FilterMask& mask);

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& /*master*/, const CellWindow& /*window*/) override {}
  void reset(double /*time*/) override { state_ = parameters_.defaultState; }

  bool state() const { return state_; }
  int changes() const { return changes_; }  // number of state changes so far

 private:
  BinaryFilterParameters parameters_;
  FilterMask mask_;
  bool state_ = false;
  int changes_ = 0;
};

/// The mask under the robot sets a speed limit (nav2_costmap_2d::SpeedFilter): base + multiplier *
/// value. 0 means no limit; unknown cells and positions off the mask keep the previous limit.
class SpeedFilter final : public CostmapLayer {
 public:
  SpeedFilter(std::string name, const CostmapContext& context,
              const SpeedFilterParameters& parameters, const FilterMask& mask);

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& /*master*/, const CellWindow& /*window*/) override {}

  /// Returns the limit if it has changed since the last call.
  std::optional<SpeedLimit> takeNewLimit();

 private:
  SpeedFilterParameters parameters_;
  FilterMask mask_;
  SpeedLimit limit_;
  bool isChanged_ = false;
};

}  // namespace sim2d::nav2
