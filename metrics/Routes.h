#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "sim2d/map/Obstacles.h"
#include "sim2d/map/PathPlanner.h"

namespace metrics {

/// Shortest ways of the robot between two points: the straight line where it is free of walls,
/// else the way round them. The planner is made at the first question that needs it. Not thread
/// safe.
class Routes {
 public:
  /// `obstacles` hold the walls of the map too.
  Routes(sim2d::OccupancyGrid map, sim2d::Obstacles obstacles, double robotRadius)
      : map_(std::move(map)), obstacles_(std::move(obstacles)), robotRadius_(robotRadius) {}

  /// Corner points, both ends included; the straight line when no way is found.
  std::vector<base::Vec2> shortest(const base::Vec2& from, const base::Vec2& to);

 private:
  sim2d::OccupancyGrid map_;
  sim2d::Obstacles obstacles_;
  double robotRadius_;
  std::unique_ptr<sim2d::PathPlanner> planner_;
};

double lengthOf(const std::vector<base::Vec2>& path);

}  // namespace metrics
