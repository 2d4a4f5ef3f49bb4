#pragma once

#include <list>
#include <memory>
#include <vector>

#include "sim2d/map/Obstacles.h"
#include "sim2d/map/PathPlanner.h"
#include "sim2d/trace/Trace.h"

namespace metrics {

using base::Vec2;

/// Shortest paths of a robot around walls. The path planner is created on first use. Not
/// synchronised.
class ShortestPaths {
 public:
  /// `obstacles` include the walls of the map; radius [m].
  ShortestPaths(sim2d::OccupancyGrid map, std::shared_ptr<const sim2d::Obstacles> obstacles,
                double robotRadius)
      : map_(std::move(map)), obstacles_(std::move(obstacles)), robotRadius_(robotRadius) {}

  /// Corner points from start to end; the straight line if there is no path. The last few results
  /// are cached, since several keys request the same path.
  std::vector<Vec2> shortest(const Vec2& from, const Vec2& to);
  /// Approximate memory usage.
  std::size_t bytes() const;

 private:
  struct Answer {
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
    std::vector<Vec2> way;
  };
  std::vector<Vec2> search(const Vec2& from, const Vec2& to);

  sim2d::OccupancyGrid map_;
  std::shared_ptr<const sim2d::Obstacles> obstacles_;
  double robotRadius_;
  std::unique_ptr<sim2d::PathPlanner> planner_;
  std::vector<Answer> known_;  // least recently used first
};

/// Cache of the routes of recent environments and robots, for consecutive runs in the same
/// environment. Results do not depend on earlier requests. Not synchronised.
class ShortestPathCache {
 public:
  /// `walls`: the map and all obstacles of the header, with open doors.
  std::shared_ptr<ShortestPaths> of(const sim2d::TraceHeader& header,
                                    const std::shared_ptr<const sim2d::Obstacles>& walls,
                                    double robotRadius);

 private:
  struct Entry {
    sim2d::OccupancyGrid map;
    std::vector<sim2d::Outline> walls;
    double robotRadius = 0.0;
    std::shared_ptr<ShortestPaths> routes;
  };
  std::size_t bytes() const;
  std::list<Entry> entries_;  // most recently used first
};

/// Precomputed data that an evaluation can reuse.
struct PrecomputedScene {
  std::shared_ptr<ShortestPathCache> routes;    // of earlier runs; null: none
  const sim2d::Obstacles* obstacles = nullptr;  // of the header, by part; null: computed
};

}  // namespace metrics
