#pragma once

#include <optional>
#include <string>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

/// Filters: what masks say of places, put over the merged costs.
namespace sim2d::nav2 {

/// The mask raises costs (nav2_costmap_2d::KeepoutFilter): 100 is 254, unknown cells say nothing.
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
  Pose2 frame_;  // of the costmap, in the map
  bool isNew_ = true;
  bool isOverridden_ = false, wasOverridden_ = false;  // the robot is in a zone and may leave it
};

/// The mask under the robot is a switch (nav2_costmap_2d::BinaryFilter): the state is
/// `default_state`, and the other one where base + multiplier * value is above `flip_threshold`. It
/// returns to the default off the mask, and stays as it is over unknown cells. It changes no costs.
class BinaryFilter final : public CostmapLayer {
 public:
  BinaryFilter(std::string name, const CostmapContext& context,
               const BinaryFilterParameters& parameters, const FilterMask& mask);

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& /*master*/, const CellWindow& /*window*/) override {}
  void reset(double /*time*/) override { state_ = parameters_.defaultState; }

  bool state() const { return state_; }
  int changes() const { return changes_; }  // of the state so far

 private:
  BinaryFilterParameters parameters_;
  FilterMask mask_;
  bool state_ = false;
  int changes_ = 0;
};

/// The mask under the robot sets a limit of speed (nav2_costmap_2d::SpeedFilter): base + multiplier
/// * value; 0 is no limit, unknown cells and places off the mask leave it as it is.
class SpeedFilter final : public CostmapLayer {
 public:
  SpeedFilter(std::string name, const CostmapContext& context,
              const SpeedFilterParameters& parameters, const FilterMask& mask);

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& /*master*/, const CellWindow& /*window*/) override {}

  /// The limit, if it has changed since the last call.
  std::optional<SpeedLimit> takeChange();

 private:
  SpeedFilterParameters parameters_;
  FilterMask mask_;
  SpeedLimit limit_;
  bool isChanged_ = false;
};

}  // namespace sim2d::nav2
