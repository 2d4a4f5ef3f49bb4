#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/OpenList.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"

namespace sim2d::nav2 {

/// nav2_theta_star_planner::ThetaStarPlanner: lazy Theta*, whose nodes may have any seen node for a
/// parent. With c' = 26 + 0.9 c a step costs w_euc |step| + w_traversal (c'/252)^2, lengths in
/// cells. Headings within the path are 0.
class ThetaStarPlanner : public GlobalPlanner {
 public:
  explicit ThetaStarPlanner(const ThetaStarParameters& parameters);

  PlanResult plan(const PlanRequest& request) override;

 private:
  struct Node {
    double g = 0.0, f = 0.0;  // cost so far, with what is still expected
    int parent = -1;          // itself at the start
  };

  int cost(Cell cell) const;
  bool isSafe(Cell cell) const;
  double lengthCost(Cell from, Cell to) const;
  double estimate(Cell cell) const;
  std::optional<double> lineCost(Cell from, Cell to) const;
  bool addSeen(Cell cell, double& sum) const;
  Cell cellOf(int index) const { return {index % costmap_.width(), index / costmap_.width()}; }
  bool search(Cell start, PlanResult& result, const base::StopFlag* stop);
  void retryParent(int index);
  void expand(int index);
  Path pathBack(const PlanRequest& request) const;

  ThetaStarParameters parameters_;
  std::array<double, 256> entered_{}, seen_{};  // what a cell of each cost adds to a step, a line
  std::array<bool, 256> isSafe_{}, isClear_{};  // to step into, to look through
  Costmap costmap_;
  Cell goal_;
  std::vector<Node> nodes_;
  OpenList<double> open_;
};

}  // namespace sim2d::nav2
