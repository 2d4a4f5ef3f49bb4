#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

namespace sim2d::nav2 {

/// The cost of an occupancy value (StaticLayer::interpretValue); `parameters` are those of the
/// costmap's node.
std::uint8_t costOfOccupancy(std::int8_t occupancy, const CostmapParameters& parameters,
                             Distro distro);
/// An axis-aligned costmap of a map; cells off a rotated map are unknown.
Costmap costmapFromMap(const OccupancyGrid& map, const CostmapParameters& parameters,
                       Distro distro);

/// The known map (nav2_costmap_2d::StaticLayer). Non-rolling costmaps have its cells; for rolling
/// ones it is sampled at the cell centres.
class StaticLayer final : public CostmapLayer {
 public:
  StaticLayer(std::string name, const CostmapContext& context,
              const StaticLayerParameters& parameters, const CostmapParameters& costmap,
              const OccupancyGrid& map);

  void updateBounds(const Observation& observation, const Costmap& master,
                    CostmapBounds& bounds) override;
  void updateCosts(Costmap& master, const CellWindow& window) override;
  void reset(double time) override;
  bool isCurrent() const override { return isCurrent_; }
  const Costmap* grid() const override { return &grid_; }

 private:
  void sampleInto(Costmap& master, const CellWindow& window) const;

  StaticLayerParameters parameters_;
  bool usesMaximum_;
  bool isNew_ = true, isCurrent_ = true;
  Pose2 frame_;        // of the costmap, in the map frame
  Polygon footprint_;  // in world frame; empty: clears nothing
  Costmap grid_;
};

}  // namespace sim2d::nav2
