#pragma once

#include <string>
#include <vector>

#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
#include "sim2d/nav/nav2/params/NodeReader.h"

namespace sim2d::nav2 {

/// Reads the node of a costmap with its layers and filters. Private to this folder.
CostmapSettings readCostmap(NodeReader& node);

}  // namespace sim2d::nav2
