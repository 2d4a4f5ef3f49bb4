#include "metrics/Routes.h"

#include "sim2d/map/DistanceField.h"

namespace metrics {

using base::Vec2;

std::vector<Vec2> Routes::shortest(const Vec2& from, const Vec2& to) {
  if (obstacles_.isVisible(from, to)) {
    return {from, to};
  }
  if (!planner_) {
    const std::vector<Vec2> bounds = {from, to};
    planner_ = std::make_unique<sim2d::PathPlanner>(
        std::make_shared<const sim2d::DistanceField>(map_, obstacles_, bounds), robotRadius_);
  }
  // The field of distances is kept per goal, and it is the start that stays the same.
  std::vector<Vec2> points = planner_->plan(to, from).points;
  if (points.empty()) {
    return {from, to};
  }
  return {points.rbegin(), points.rend()};
}

double lengthOf(const std::vector<Vec2>& path) {
  double length = 0.0;
  for (std::size_t k = 1; k < path.size(); ++k) {
    length += (path[k] - path[k - 1]).norm();
  }
  return length;
}

}  // namespace metrics
