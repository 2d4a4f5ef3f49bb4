#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/nav/nav2/Nav2Key.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"
#include "sim2d/nav/nav2/global/StaleHeap.h"
#include "sim2d/nav/nav2/global/ThetaStarLines.h"

namespace sim2d::nav2 {

/// nav2_theta_star_planner::ThetaStarPlanner: lazy Theta*. A node is first reached from a
/// neighbour; when it is expanded its parent's parent is tried instead, along a straight line. A
/// step costs w_euc |step| + w_traversal (c'/252)^2 and the estimate is min(1, w_euc) times the
/// distance to the goal, lengths in cells. Headings within the path are 0.
///
/// As in Nav2 the search fails when its queue runs empty, even if the node popped last is the goal:
/// in a corridor one cell wide there is no path. Since an improved node keeps its place in the
/// heap, the path is not always the cheapest that these steps allow.
class ThetaStarPlanner : public GlobalPlanner {
 public:
  ThetaStarPlanner(const ThetaStarParameters& parameters, Distro distro);

  PlanResult plan(const PlanRequest& request) override;

 private:
  struct Node {
    double g = 0.0, f = 0.0;  // cost so far, with the estimate
    int parent = -1;          // index of a cell; itself at the start
    bool isQueued = false;
  };

  bool isSafe(Cell cell) const { return costs_.isSafe[costmap_.at(cell)]; }
  double lengthCost(Cell from, Cell to) const;
  double estimate(Cell cell) const;
  Cell cellOf(int index) const { return {index % costmap_.width(), index / costmap_.width()}; }
  double keyOf(std::size_t index) const { return nodes_[index].f; }
  bool search(Cell start, PlanResult& result, const base::StopFlag* stop);
  void retryParent(int index);
  void expand(int index);
  Path pathBack(const PlanRequest& request) const;

  ThetaStarParameters parameters_;
  Distro distro_;
  ThetaStarCosts costs_;
  Costmap costmap_;
  Cell goal_;
  std::vector<Node> nodes_;
  StaleHeap queue_;
};

}  // namespace sim2d::nav2
