#pragma once

#include <cstdint>
#include <optional>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"

/// What the Smac planners share.
namespace sim2d::nav2 {

constexpr double kSmacMostCost = 252.0;  // divides costs, so that they reach 1 beside collisions

/// Whether a round robot may have its centre there.
constexpr bool isSmacFree(std::uint8_t cost, bool allowUnknown) {
  return cost == kNoInformation ? allowUnknown : cost < kInscribed;
}

/// Cells of `factor` by `factor` become one, with the highest or the least of their costs.
Costmap downsampled(const Costmap& costmap, int factor, bool takesLeast);

/// The limits of a search, in iterations.
struct SmacLimits {
  int most = 0, mostOnApproach = 0, checkEvery = 0;
};
SmacLimits smacLimits(const SmacParameters& parameters, double maxPlanningTime, double perSecond);

/// The cell that comes nearest to the goal, for the tolerance.
struct SmacNearest {
  double estimate = 1e30;  // what is expected from there [cells]
  std::size_t node = 0;

  void offer(double nodeEstimate, std::size_t index) {
    if (nodeEstimate < estimate) {
      estimate = nodeEstimate;
      node = index;
    }
  }
};

}  // namespace sim2d::nav2
