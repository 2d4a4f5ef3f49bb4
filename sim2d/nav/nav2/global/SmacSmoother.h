#pragma once

#include <optional>

#include "sim2d/nav/nav2/global/PlannerParameters.h"
#include "sim2d/nav/nav2/global/ShortestCurve.h"

namespace sim2d::nav2 {

/// A car, for smoothing: what it must be able to drive.
struct SmoothedCar {
  CarMotion motion = CarMotion::Dubins;
  double turningRadius = 0.4;  // R [m]
};

/// The smoother inside the Smac planners: sweeps, for a car also curves that it can drive from the
/// start and to the end of each segment. Its time limit is its number of sweeps.
void smoothSmacPath(Path& path, const SmacParameters& parameters, const Costmap& costmap,
                    const std::optional<SmoothedCar>& car);

}  // namespace sim2d::nav2
