#pragma once

#include <array>
#include <optional>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"

/// Costs of cells and lines of sight of Nav2's Theta* (nav2_theta_star_planner, theta_star.cpp).
namespace sim2d::nav2 {

/// Planner costs for each cell cost from 0 to 255. With c' = 26 + 0.9 c a cell costs w_traversal
/// (c' / 252)^2.
struct ThetaStarCosts {
  explicit ThetaStarCosts(const ThetaStarParameters& parameters);

  std::array<double, 256> stepCosts{};  // cost of a step into the cell
  std::array<double, 256> lineCosts{};  // cost of a line over the cell; c' is 253 where c is 255
  std::array<bool, 256> isSafe{};       // c <= 252, or 255 if unknown cells are allowed
  std::array<bool, 256> isClear{};      // c' <= 252 (c <= 251), or 255 if unknown cells are allowed
};

/// The cost of a line of sight, summed over its cells like `losCheck` of the branch; nullopt if a
/// cell blocks it. Precondition: both cells are inside the costmap.
///
/// Humble to Kilted: the line runs between the lower left corners of the cells, as in the paper of
/// Daniel, Nash, Koenig and Felner (2010); a line along an axis is blocked only if the cells on
/// both of its sides are. Beside the map these branches read memory with an index that wraps
/// around: as there, a cell of column -1 is the last one of the row below; here an index outside
/// the array blocks.
///
/// Since Lyrical: Bresenham's line with e = dx - dy, including the first cell but not the last. It
/// steps in x if 2 e > -dy and in y if 2 e <= dx. If both, the two side cells must be safe.
std::optional<double> thetaStarLineCost(const Costmap& costmap, const ThetaStarCosts& costs,
                                        Distro distro, Cell from, Cell to);

/// sqrt(x^2 + y^2) with the rounding of hypot in glibc >= 2.35, which Nav2 uses from Humble on, so
/// that equal costs stay equal. Valid for lengths of any usual map.
double hypotAsGlibc(double x, double y);

}  // namespace sim2d::nav2
