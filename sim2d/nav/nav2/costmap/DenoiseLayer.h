#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

namespace sim2d::nav2 {

/// Frees small groups of obstacle cells in the merged costs (nav2_costmap_2d::DenoiseLayer). As in
/// Nav2 an obstacle is a cell of cost 254 or 253, or an unknown one in a costmap that does not
/// track unknown space. Groups are searched only in the updated window, so one at its border may be
/// cut.
class DenoiseLayer final : public CostmapLayer {
 public:
  DenoiseLayer(std::string name, const CostmapContext& context,
               const DenoiseLayerParameters& parameters)
      : CostmapLayer(std::move(name), context), parameters_(parameters) {}

  void updateBounds(const Observation& /*observation*/, const Costmap& /*master*/,
                    CostmapBounds& /*bounds*/) override {}
  void updateCosts(Costmap& master, const CellWindow& window) override;

 private:
  bool isObstacle(std::uint8_t cost) const {
    return cost == kLethal || cost == kInscribed ||
           (cost == kNoInformation && !context().tracksUnknown);
  }
  void findGroup(const Costmap& master, const CellWindow& window, Cell from);

  DenoiseLayerParameters parameters_;
  std::vector<char> seen_;   // cells of the window, row-major
  std::vector<Cell> group_;  // the last group found
};

}  // namespace sim2d::nav2
