#pragma once

#include <cstdint>

#include "sim2d/nav/nav2/Costmap.h"

namespace sim2d::nav2 {

/// How costs fall off round lethal cells (nav2_costmap_2d, inflation_layer.hpp, computeCost).
struct InflationLaw {
  double radius = 0.55;    // nothing beyond it [m]
  double scaling = 10.0;   // cost_scaling_factor [1/m]
  double inscribed = 0.1;  // r_in of the robot [m]

  /// At a distance between centres of cells [m]: 254 at 0, 253 up to r_in, then
  /// trunc(252 exp(-scaling (d - r_in))), also beyond `radius`.
  std::uint8_t cost(double distance) const;
  /// The other way round, as MPPI's ObstaclesCritic and Regulated Pure Pursuit have it:
  /// r_in - ln(cost / 253) / scaling for costs in [1, 253] [m]; from the centre of the robot.
  double distance(std::uint8_t cost) const;
};

}  // namespace sim2d::nav2
