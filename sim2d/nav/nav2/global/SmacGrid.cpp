#include "sim2d/nav/nav2/global/SmacGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim2d::nav2 {

Costmap downsampled(const Costmap& costmap, int factor, bool takesLeast) {
  if (factor <= 1) {
    return costmap;
  }
  const auto shrunk = [factor](int cells) { return (cells + factor - 1) / factor; };
  Costmap small(shrunk(costmap.width()), shrunk(costmap.height()), costmap.resolution() * factor,
                costmap.origin(), takesLeast ? kNoInformation : kFreeSpace);
  for (int row = 0; row < costmap.height(); ++row) {
    for (int column = 0; column < costmap.width(); ++column) {
      std::uint8_t& cost = small.costs()[small.indexOf({column / factor, row / factor})];
      const std::uint8_t found = costmap.at({column, row});
      cost = takesLeast ? std::min(cost, found) : std::max(cost, found);
    }
  }
  return small;
}

SmacLimits smacLimits(const SmacParameters& parameters, double maxPlanningTime, double perSecond) {
  constexpr int kNone = std::numeric_limits<int>::max();
  const auto limit = [](int given) { return given > 0 ? given : kNone; };
  const double inTime =
      std::clamp(std::round(maxPlanningTime * perSecond), 1.0, static_cast<double>(kNone));
  return {std::min(limit(parameters.maxIterations), static_cast<int>(inTime)),
          limit(parameters.maxOnApproachIterations),
          std::max(1, parameters.terminalCheckingInterval)};
}

}  // namespace sim2d::nav2
