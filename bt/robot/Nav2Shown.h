#pragma once

#include <cstdint>
#include <vector>

#include "sim2d/map/CostGrid.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/nav2/control/Controller.h"
#include "sim2d/nav/nav2/costmap/LayeredCostmap.h"

/// What Nav2's servers hold, as a display wants it.
namespace bt {

std::vector<base::Vec2> pointsOf(const sim2d::nav2::Path& path);

/// A trajectory with its price. Scores are scale * raw, of critics that were asked; one that is
/// refused costs infinitely much.
sim2d::Candidate shownWay(const sim2d::nav2::WeighedTrajectory& trajectory);

/// A copy of a costmap, made again when it has been updated.
class ShownCosts {
 public:
  sim2d::CostGridPtr of(const sim2d::nav2::LayeredCostmap& costmap);

 private:
  sim2d::CostGridPtr copy_;
  std::int64_t updates_ = -1;  // of the costmap, when the copy was made
};

}  // namespace bt
