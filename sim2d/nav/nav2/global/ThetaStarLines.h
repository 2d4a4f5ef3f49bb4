#pragma once

#include <array>
#include <optional>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2Key.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"

/// Costs of cells and straight lines of Nav2's Theta* (nav2_theta_star_planner, theta_star.cpp).
namespace sim2d::nav2 {

/// What cells of each cost from 0 to 255 mean to the planner. With c' = 26 + 0.9 c a cell costs
/// w_traversal (c' / 252)^2.
struct ThetaStarCosts {
  explicit ThetaStarCosts(const ThetaStarParameters& parameters);

  std::array<double, 256> entered{};  // a step into the cell
  std::array<double, 256> crossed{};  // a line over the cell; c' is 253 where c is 255
  std::array<bool, 256> isSafe{};     // c <= 252, or 255 if unknown cells are allowed
  std::array<bool, 256> isClear{};    // c' <= 252 (c <= 251), or 255 if unknown cells are allowed
};

/// What a straight line costs by the cells that it crosses, as `losCheck` of the branch adds them
/// up; none if a cell blocks it. Both cells must be inside of the costmap.
///
/// Humble to Kilted: the line runs between the lower left corners of the cells, as in the paper of
/// Daniel, Nash, Koenig and Felner (2010); a line along an axis is blocked only where the cells on
/// both of its sides are. Beside the map these branches read memory by an index that wraps around:
/// here a cell of column -1 is the last one of the row below, as there, and what lies outside of
/// the array blocks.
///
/// Since Lyrical: Bresenham's line with e = dx - dy; the first cell counts, the last does not. It
/// steps in x if 2 e > -dy and in y if 2 e <= dx. If both, the two side cells must be safe.
std::optional<double> thetaStarLine(const Costmap& costmap, const ThetaStarCosts& costs,
                                    Distro distro, Cell from, Cell to);

/// sqrt(x^2 + y^2) with the rounding of the C library's hypot (glibc since 2.35, which Nav2 runs on
/// from Humble on), so that equal costs are equal there and here. For lengths of any usual map.
double hypotAsGlibc(double x, double y);

}  // namespace sim2d::nav2
