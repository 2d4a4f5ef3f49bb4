#include "sim2d/nav/nav2/global/SmacLatticePlanner.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "sim2d/nav/nav2/global/LatticeSearch.h"
#include "sim2d/nav/nav2/global/SmacSmoother.h"

namespace sim2d::nav2 {
namespace {

constexpr double kNoLatticeTolerance = 1e-3;  // [cells]

Pose2 inCellsOf(const Costmap& costmap, const Pose2& pose) {
  const Vec2 place = (pose.position - costmap.origin()) / costmap.resolution();
  return {place.array().floor() + 0.5, pose.heading};
}

Cell cellBelow(const Pose2& pose) {
  return {static_cast<int>(pose.position.x()), static_cast<int>(pose.position.y())};
}

/// The goal with the headings that `goal_heading_mode` allows.
std::vector<Pose2> latticeGoals(const SmacLatticeParameters& parameters, Distro distro,
                                const Pose2& goal) {
  const Lattice& lattice = *parameters.lattice;
  const int heading = lattice.nearestHeading(goal.heading);
  std::vector<int> headings = {heading};
  if (distro >= Distro::Kilted && parameters.goalHeadingMode == "BIDIRECTIONAL") {
    headings.push_back(lattice.oppositeOf(heading));
  } else if (distro >= Distro::Kilted && parameters.goalHeadingMode == "ALL_DIRECTION") {
    for (int i = 1; i < lattice.size(); ++i) {
      headings.push_back((heading + i) % lattice.size());
    }
  }
  std::vector<Pose2> goals;
  goals.reserve(headings.size());
  for (const int each : headings) {
    goals.push_back({goal.position, lattice.headings[static_cast<std::size_t>(each)]});
  }
  return goals;
}

}  // namespace

SmacLatticePlanner::SmacLatticePlanner(const SmacLatticeParameters& parameters, Distro distro)
    : parameters_(parameters), distro_(distro) {
  assert(parameters.lattice != nullptr);
}

PlanResult SmacLatticePlanner::plan(const PlanRequest& request) {
  const Costmap& costmap = request.costmap;
  if (!costmap.worldToCell(request.start.position)) {
    return {PlanError::StartOutsideMap, {}, 0};
  }
  if (!costmap.worldToCell(request.goal.position)) {
    return {PlanError::GoalOutsideMap, {}, 0};
  }
  if (!std::isfinite(request.start.heading) || !std::isfinite(request.goal.heading)) {
    return {PlanError::Unknown, {}, 0};
  }
  PlanResult result = planIn(costmap, request);
  for (Pose2& pose : result.path) {
    pose.position = costmap.origin() + costmap.resolution() * pose.position;
  }
  if (parameters_.smoothPath && result.iterations > 1) {
    const CarMotion car =
        parameters_.allowReverseExpansion ? CarMotion::ReedsShepp : CarMotion::Dubins;
    smoothSmacPath(result.path, parameters_, costmap,
                   SmoothedCar{car, parameters_.lattice->turningRadius});
  }
  return result;
}

/// The path in cells.
PlanResult SmacLatticePlanner::planIn(Costmap costmap, const PlanRequest& request) {
  const Pose2 start = inCellsOf(costmap, request.start);
  const std::vector<Pose2> goals =
      latticeGoals(parameters_, distro_, inCellsOf(costmap, request.goal));
  if (distro_ != Distro::Humble) {
    costmap.set(cellBelow(start), kFreeSpace);
  }
  LatticeSearch search({parameters_, distro_, *parameters_.lattice, costmap, request, obstacles_});
  if (distro_ == Distro::Humble && !search.costAt(start)) {
    return {PlanError::StartOccupied, {}, 0};
  }
  const auto isFree = [&](const Pose2& goal) { return search.costAt(goal).has_value(); };
  if (parameters_.tolerance / costmap.resolution() < kNoLatticeTolerance &&
      std::none_of(goals.begin(), goals.end(), isFree)) {
    return {PlanError::GoalOccupied, {}, 0};
  }
  if (cellBelow(start) == cellBelow(goals.front()) &&
      parameters_.lattice->nearestHeading(start.heading) ==
          parameters_.lattice->nearestHeading(goals.front().heading)) {
    return {PlanError::None, {{start.position, request.goal.heading}}, 0};
  }
  ObstacleDistance::Settings settings;
  settings.costPenalty = parameters_.costPenalty;
  settings.isQuadratic = distro_ >= Distro::Lyrical && parameters_.useQuadraticCostPenalty;
  settings.allowUnknown = parameters_.allowUnknown;
  settings.isDownsampled = parameters_.downsampleObstacleHeuristic;
  obstacles_.start(costmap, cellBelow(goals.front()), settings, parameters_.cacheObstacleHeuristic);
  return search.find(start, goals);
}

}  // namespace sim2d::nav2
