#pragma once

#include <memory>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/LayeredCostmap.h"

namespace sim2d::nav2 {

/// The layer or filter of a costmap. `context` must live as long as it does; `master`: size and
/// place of the costmap. Private to this folder.
std::unique_ptr<CostmapLayer> makeLayer(const CostmapPlugin& plugin, const CostmapSetup& setup,
                                        const CostmapContext& context, const Costmap& master);

}  // namespace sim2d::nav2
