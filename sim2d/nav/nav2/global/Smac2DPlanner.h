#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/OpenList.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"
#include "sim2d/nav/nav2/global/SmacCommon.h"

namespace sim2d::nav2 {

/// nav2_smac_planner::SmacPlanner2D: A* over cells and their eight neighbours; a step costs L (1 +
/// cost_travel_multiplier c / 252), L = 1 or sqrt 2. Smooths its path.
class Smac2DPlanner : public GlobalPlanner {
 public:
  Smac2DPlanner(const Smac2DParameters& parameters, Distro distro);

  PlanResult plan(const PlanRequest& request) override;

 private:
  struct Node {
    float g = 0.0F;  // cost so far
    std::int32_t parent = -1;
    bool isVisited = false;
  };

  void search(Cell start, PlanResult& result, const base::StopFlag* stop);
  void expand(std::size_t index);
  void collect(std::size_t end, Path& path) const;
  void finish(const PlanRequest& request, Path& path) const;
  float estimate(Cell cell) const;
  double toleranceInCells() const { return parameters_.tolerance / costmap_.resolution(); }
  Cell cellOf(std::size_t index) const;

  Smac2DParameters parameters_;
  Distro distro_;
  Costmap costmap_;
  Cell goal_;
  std::vector<Node> nodes_;
  OpenList<float> open_;
  NearestNode nearest_;
};

}  // namespace sim2d::nav2
