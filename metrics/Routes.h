#pragma once

#include <memory>
#include <vector>

#include "sim2d/map/Obstacles.h"

namespace metrics {

/// Shortest ways of the robot between two points: the straight line where it is free of walls,
/// else the way round them. The planner is made at the first question that needs it. Not thread
/// safe.
class Routes {
 public:
  /// `obstacles` hold the walls of the map too.
  Routes(sim2d::OccupancyGrid map, sim2d::Obstacles obstacles, double robotRadius);
  ~Routes();
  Routes(const Routes&) = delete;
  Routes& operator=(const Routes&) = delete;
  Routes(Routes&&) = delete;
  Routes& operator=(Routes&&) = delete;

  /// Corner points, both ends included; the straight line when no way is found.
  std::vector<base::Vec2> shortest(const base::Vec2& from, const base::Vec2& to);

 private:
  struct Planner;
  sim2d::OccupancyGrid map_;
  sim2d::Obstacles obstacles_;
  double robotRadius_;
  std::unique_ptr<Planner> planner_;
};

double lengthOf(const std::vector<base::Vec2>& path);

}  // namespace metrics
