#pragma once

#include <list>
#include <memory>
#include <vector>

#include "sim2d/map/Obstacles.h"
#include "sim2d/map/PathPlanner.h"
#include "sim2d/trace/Trace.h"

namespace metrics {

using base::Vec2;

/// Shortest ways of a robot round the walls. The planner is made at the first question that needs
/// it. One thread.
class Routes {
 public:
  /// `obstacles` hold the walls of the map too; radius [m].
  Routes(sim2d::OccupancyGrid map, std::shared_ptr<const sim2d::Obstacles> obstacles,
         double robotRadius)
      : map_(std::move(map)), obstacles_(std::move(obstacles)), robotRadius_(robotRadius) {}

  /// Corner points from end to end; the straight line where no way leads there. Some keys ask the
  /// same: the last few answers are kept.
  std::vector<Vec2> shortest(const Vec2& from, const Vec2& to);
  /// Memory taken, about.
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
  std::vector<Answer> known_;  // the last used last
};

/// The routes of the last few surroundings and robots, for runs one after the other in the same
/// ones: the answers do not depend on what was asked before. One thread.
class KnownRoutes {
 public:
  /// `walls`: of the map and all obstacles of the header, doors open.
  std::shared_ptr<Routes> of(const sim2d::TraceHeader& header,
                             const std::shared_ptr<const sim2d::Obstacles>& walls,
                             double robotRadius);

 private:
  struct Entry {
    sim2d::OccupancyGrid map;
    std::vector<sim2d::Outline> walls;
    double robotRadius = 0.0;
    std::shared_ptr<Routes> routes;
  };
  std::size_t bytes() const;
  std::list<Entry> entries_;  // last used first
};

/// What the evaluation of a run need not work out itself.
struct KnownScene {
  std::shared_ptr<KnownRoutes> routes;          // of runs before; null: none
  const sim2d::Obstacles* obstacles = nullptr;  // of the header, part by part; null: to be built
};

}  // namespace metrics
