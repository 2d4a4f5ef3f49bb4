#include "sim2d/nav/nav2/global/NavfnPlanner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim2d/nav/nav2/global/PathEnds.h"

namespace sim2d::nav2 {
namespace {

/// The cell whose lower left corner is nearest; may lie one beyond the upper and right border.
Cell roundedCell(const Costmap& costmap, const Vec2& place) {
  const Vec2 cells = (place - costmap.origin()) / costmap.resolution();
  return {static_cast<int>(std::round(cells.x())), static_cast<int>(std::round(cells.y()))};
}

PlanResult navfnFailure(PlanError error, int iterations = 0) {
  return {error, {}, iterations};
}

}  // namespace

NavfnPlanner::NavfnPlanner(const NavfnParameters& parameters, Distro distro)
    : parameters_(parameters), distro_(distro) {}

PlanResult NavfnPlanner::plan(const PlanRequest& request) {
  const Costmap& costmap = request.costmap;
  const auto start = costmap.worldToCell(request.start.position);
  const auto goal = costmap.worldToCell(request.goal.position);
  if (!start || !costmap.contains(roundedCell(costmap, request.start.position))) {
    return navfnFailure(PlanError::StartOutsideMap);
  }
  if (!goal || !costmap.contains(roundedCell(costmap, request.goal.position))) {
    return navfnFailure(PlanError::GoalOutsideMap);
  }
  if (distro_ >= Distro::Lyrical && parameters_.tolerance == 0.0 && costmap.at(*goal) == kLethal) {
    return navfnFailure(PlanError::GoalOccupied);
  }
  if (request.start.position == request.goal.position) {
    if (costmap.at(*start) == kLethal) {
      return navfnFailure(PlanError::StartOccupied);
    }
    return {PlanError::None,
            {poseOnTheSpot(request.start, request.goal, parameters_.useFinalApproachOrientation)}};
  }
  const Cell robot = roundedCell(costmap, request.start.position);
  wave_.setCosts(costmap, parameters_.allowUnknown);
  wave_.free(robot);
  const int updated = wave_.spread(robot, roundedCell(costmap, request.goal.position),
                                   parameters_.useAstar, request.stop);
  const auto end = nearestReached(costmap, request.goal);
  PlanResult result = end ? pathTo(request, *end) : navfnFailure(PlanError::NoValidPath);
  result.iterations = updated;
  return result;
}

float NavfnPlanner::potentialAt(const Costmap& costmap, const Vec2& place) const {
  const Cell cell = roundedCell(costmap, place);
  return costmap.contains(cell) ? wave_.potential(cell) : std::numeric_limits<float>::max();
}

/// The goal, or the first of the nearest places to it that the wave came to.
std::optional<Pose2> NavfnPlanner::nearestReached(const Costmap& costmap, const Pose2& goal) const {
  if (potentialAt(costmap, goal.position) < NavfnWave::kUnreached) {
    return goal;
  }
  const double reach = parameters_.tolerance, step = costmap.resolution();
  double least = std::numeric_limits<double>::max();
  std::optional<Pose2> nearest;
  Vec2 place = goal.position - Vec2::Constant(reach);  // sums of steps, as in Nav2
  while (place.y() <= goal.position.y() + reach) {
    place.x() = goal.position.x() - reach;
    while (place.x() <= goal.position.x() + reach) {
      const double distance = (place - goal.position).squaredNorm();
      if (distance < least && potentialAt(costmap, place) < NavfnWave::kUnreached) {
        least = distance;
        nearest = Pose2{place, goal.heading};
      }
      place.x() += step;
    }
    place.y() += step;
  }
  return nearest;
}

PlanResult NavfnPlanner::pathTo(const PlanRequest& request, const Pose2& end) {
  const Costmap& costmap = request.costmap;
  const int factor = distro_ >= Distro::Lyrical ? parameters_.maxCyclesFactor : 4;
  const int steps = std::max(costmap.width(), costmap.height()) * factor;
  const std::vector<Vec2> cells = wave_.descend(roundedCell(costmap, end.position), steps);
  if (cells.empty()) {
    return navfnFailure(PlanError::NoValidPath);
  }
  PlanResult result;
  for (auto cell = cells.rbegin(); cell != cells.rend(); ++cell) {
    result.path.push_back({costmap.origin() + costmap.resolution() * *cell, 0.0});
  }
  approach(result.path, end);
  if (parameters_.useFinalApproachOrientation) {
    faceAlongPath(result.path, request.start.heading);
  }
  return result;
}

/// Ends the path with the goal, in place of a last pose that lies beyond it.
void NavfnPlanner::approach(Path& path, const Pose2& goal) const {
  if (path.size() >= 2) {
    constexpr double kSame = 1e-3;  // [m]
    const Vec2& last = path.back().position;
    const Vec2& before = path[path.size() - 2].position;
    const bool isBeyond = (last - before).squaredNorm() > (goal.position - before).squaredNorm();
    const bool isThere =
        distro_ != Distro::Humble && (last - goal.position).squaredNorm() < kSame * kSame;
    if (isBeyond || isThere) {
      path.back() = goal;
      return;
    }
  }
  path.push_back(goal);
}

}  // namespace sim2d::nav2
