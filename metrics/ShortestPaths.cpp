#include "metrics/ShortestPaths.h"

#include <algorithm>
#include <numeric>

#include "sim2d/map/Obstacles.h"

namespace metrics {

namespace {

constexpr std::size_t kMostEntries = 8;
constexpr std::size_t kMaxBytes = std::size_t{192} << 20U;
constexpr std::size_t kBytesPerCell = 10;  // of the distance field and the open list

/// Obstacles except doors.
std::vector<sim2d::Outline> wallsOf(const sim2d::TraceHeader& header) {
  std::vector<sim2d::Outline> walls;
  for (const sim2d::TraceObstacle& obstacle : header.obstacles) {
    if (!obstacle.isDoor) {
      walls.insert(walls.end(), obstacle.outlines.begin(), obstacle.outlines.end());
    }
  }
  return walls;
}

}  // namespace

std::vector<Vec2> ShortestPaths::shortest(const Vec2& from, const Vec2& to) {
  constexpr std::size_t kMaxKept = 4;
  const auto found = std::find_if(known_.begin(), known_.end(), [&](const Answer& known) {
    return known.from == from && known.to == to;
  });
  if (found != known_.end()) {
    std::rotate(found, found + 1, known_.end());
    return known_.back().way;
  }
  if (known_.size() >= kMaxKept) {
    known_.erase(known_.begin());
  }
  known_.push_back({from, to, search(from, to)});
  return known_.back().way;
}

std::vector<Vec2> ShortestPaths::search(const Vec2& from, const Vec2& to) {
  const double room =
      std::min({robotRadius_, obstacles_->clearance(from), obstacles_->clearance(to)});
  if (sim2d::isSegmentFree(from, to, *obstacles_, std::max(room, 0.0))) {
    return {from, to};
  }
  if (!planner_) {
    const std::vector<Vec2> bounds = {from, to};
    planner_ = std::make_unique<sim2d::PathPlanner>(
        sim2d::DistanceField::withExactDistances(map_, *obstacles_, bounds), robotRadius_,
        sim2d::PathObjective::Length);
  }
  // The distance field is cached per goal, and requests share their start.
  std::vector<Vec2> path = planner_->plan(to, from);
  std::reverse(path.begin(), path.end());
  return path.empty() ? std::vector<Vec2>{from, to}
                      : sim2d::tightened(path, *obstacles_, robotRadius_);
}

std::shared_ptr<ShortestPaths> ShortestPathCache::of(
    const sim2d::TraceHeader& header, const std::shared_ptr<const sim2d::Obstacles>& walls,
    double robotRadius) {
  if (header.map.isEmpty()) {  // the search area then depends on the first request
    return std::make_shared<ShortestPaths>(header.map, walls, robotRadius);
  }
  std::vector<sim2d::Outline> outlines = wallsOf(header);
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.robotRadius == robotRadius && entry.map == header.map && entry.walls == outlines;
  });
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
  } else {
    entries_.push_front({header.map, std::move(outlines), robotRadius,
                         std::make_shared<ShortestPaths>(header.map, walls, robotRadius)});
  }
  std::shared_ptr<ShortestPaths> routes = entries_.front().routes;
  while (entries_.size() > kMostEntries || bytes() > kMaxBytes) {
    entries_.pop_back();
  }
  return routes;
}

std::size_t ShortestPaths::bytes() const {
  return planner_ != nullptr ? kBytesPerCell * map_.cells().size() + planner_->bytes() : 0;
}

std::size_t ShortestPathCache::bytes() const {
  return std::accumulate(
      entries_.begin(), entries_.end(), std::size_t{0},
      [](std::size_t sum, const Entry& entry) { return sum + entry.routes->bytes(); });
}

}  // namespace metrics
