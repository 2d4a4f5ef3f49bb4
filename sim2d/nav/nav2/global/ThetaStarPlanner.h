#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/OpenList.h"
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

/// nav2_theta_star_planner::ThetaStarPlanner: lazy Theta*. A node is first reached from a
/// neighbour; when it is expanded, its parent's parent is tried along a line of sight. A step costs
/// w_euc |step| + w_traversal (c'/252)^2 and the estimate is min(1, w_euc) times the distance to
/// the goal, lengths in cells. Headings within the path are 0.
///
/// As in Nav2 the search fails when its queue becomes empty, even if the last popped node is the
/// goal: a corridor one cell wide has no path. Since an improved node keeps its place in the heap,
/// the path is not always the cheapest.
class ThetaStarPlanner : public GlobalPlanner {
 public:
  ThetaStarPlanner(const ThetaStarParameters& parameters, Distro distro);

  PlanResult plan(const PlanRequest& request) override;

 private:
  struct Node {
    double g = 0.0, f = 0.0;  // cost so far; with the estimate
    int parent = -1;          // index of a cell; the start is its own parent
    bool isQueued = false;
  };

  bool isSafe(Cell cell) const { return costs_.isSafe[costmap_.at(cell)]; }
  double lengthCost(Cell from, Cell to) const;
  double estimate(Cell cell) const;
  Cell cellOf(int index) const { return {index % costmap_.width(), index / costmap_.width()}; }
  double keyOf(std::size_t index) const { return nodes_[index].f; }
  bool search(Cell start, PlanResult& result, const base::StopFlag* stop);
  void tryGrandparent(int index);
  void expand(int index);
  Path backtrace(const PlanRequest& request) const;

  ThetaStarParameters parameters_;
  Distro distro_;
  ThetaStarCosts costs_;
  Costmap costmap_;
  Cell goal_;
  std::vector<Node> nodes_;
  StaleHeap queue_;
};

}  // namespace sim2d::nav2
