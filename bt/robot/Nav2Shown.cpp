#include "bt/robot/Nav2Shown.h"

#include <limits>
#include <memory>

namespace bt {

std::vector<base::Vec2> pointsOf(const sim2d::nav2::Path& path) {
  std::vector<base::Vec2> points;
  points.reserve(path.size());
  for (const base::Pose2& pose : path) {
    points.push_back(pose.position);
  }
  return points;
}

sim2d::Candidate shownWay(const sim2d::nav2::WeighedTrajectory& trajectory) {
  sim2d::Candidate way;
  way.points = pointsOf(trajectory.poses);
  way.cost =
      trajectory.refusal.empty() ? trajectory.total : std::numeric_limits<double>::infinity();
  way.isChosen = trajectory.isChosen;
  for (const sim2d::nav2::CriticScore& score : trajectory.scores) {
    if (score.scale != 0.0) {
      way.scores.emplace_back(score.critic, score.scale * score.raw);
    }
  }
  return way;
}

sim2d::CostGridPtr ShownCosts::of(const sim2d::nav2::LayeredCostmap& costmap) {
  if (copy_ == nullptr || updates_ != costmap.updates()) {
    const sim2d::nav2::Costmap& now = costmap.costmap();
    auto grid = std::make_shared<sim2d::CostGrid>();
    grid->columns = now.width();
    grid->rows = now.height();
    grid->resolution = now.resolution();
    grid->origin = now.origin();
    grid->costs = now.costs();
    copy_ = std::move(grid);
    updates_ = costmap.updates();
  }
  return copy_;
}

}  // namespace bt
