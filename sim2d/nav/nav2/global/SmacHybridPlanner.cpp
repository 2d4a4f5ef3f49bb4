#include "sim2d/nav/nav2/global/SmacHybridPlanner.h"

#include <algorithm>
#include <cmath>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/HybridSearch.h"
#include "sim2d/nav/nav2/global/SmacCommon.h"

namespace sim2d::nav2 {
namespace {

constexpr double kNoHybridTolerance = 1e-3;  // [cells]

Cell cellUnder(const Pose2& inCells) {
  return {static_cast<int>(inCells.position.x()), static_cast<int>(inCells.position.y())};
}

PlanResult hybridFailure(PlanError error) {
  return {error, {}, 0};
}

}  // namespace

SmacHybridPlanner::SmacHybridPlanner(const SmacHybridParameters& parameters, Distro distro)
    : parameters_(parameters), distro_(distro) {}

PlanResult SmacHybridPlanner::plan(const PlanRequest& request) {
  const int factor = parameters_.downsampleCostmap ? parameters_.downsamplingFactor : 1;
  const Costmap costmap = downsampled(request.costmap, factor, false);
  if (!costmap.worldToCell(request.start.position)) {
    return hybridFailure(PlanError::StartOutsideMap);
  }
  if (!costmap.worldToCell(request.goal.position)) {
    return hybridFailure(PlanError::GoalOutsideMap);
  }
  if (!std::isfinite(request.start.heading) || !std::isfinite(request.goal.heading)) {
    return hybridFailure(PlanError::Unknown);
  }
  PlanResult result = planIn(costmap, request);
  for (Pose2& pose : result.path) {
    pose.position = costmap.origin() + costmap.resolution() * pose.position;
  }
  if (parameters_.smoothPath && result.iterations > 1) {
    const double radius = std::max(parameters_.minimumTurningRadius, costmap.resolution());
    const CarMotion car = parameters_.motionModelForSearch == "REEDS_SHEPP" ? CarMotion::ReedsShepp
                                                                            : CarMotion::Dubins;
    smoothSmacPath(result.path, parameters_, request.costmap, CarModel{car, radius});
  }
  return result;
}

Pose2 SmacHybridPlanner::inCells(const Costmap& costmap, const Pose2& pose) const {
  Vec2 place = (pose.position - costmap.origin()) / costmap.resolution();
  if (distro_ < Distro::Lyrical) {
    place = place.array().floor() + 0.5;
  }
  return {place, pose.heading};
}

/// The goal with the headings that `goal_heading_mode` allows.
std::vector<Pose2> SmacHybridPlanner::goalsAt(const HybridMotion& motion, const Pose2& goal) const {
  const bool knowsModes = distro_ >= Distro::Kilted;
  const int bin = motion.nearestBin(goal.heading);
  std::vector<int> bins = {bin};
  if (knowsModes && parameters_.goalHeadingMode == "BIDIRECTIONAL") {
    bins.push_back(motion.wrappedBin(bin + motion.bins() / 2));
  } else if (knowsModes && parameters_.goalHeadingMode == "ALL_DIRECTION") {
    for (int i = 1; i < motion.bins(); ++i) {
      bins.push_back(motion.wrappedBin(bin + i));
    }
  }
  std::vector<Pose2> goals;
  goals.reserve(bins.size());
  for (const int each : bins) {
    goals.push_back({goal.position, base::wrapToPi(each * motion.binSize())});
  }
  return goals;
}

DistanceHeuristic& SmacHybridPlanner::curvesFor(const HybridMotion& motion,
                                                const Costmap& costmap) {
  constexpr double kMaxSide = 2000.0;  // [cells]
  const double wanted = std::fmin(parameters_.lookupTableSize / costmap.resolution(), kMaxSide);
  const int side = static_cast<int>(wanted) | 1;  // odd
  if (!curves_ || curveRadius_ != motion.turningRadius() || curveSide_ != side) {
    curves_.emplace(motion.car(), motion.turningRadius(), motion.bins(), side);
    curveRadius_ = motion.turningRadius();
    curveSide_ = side;
  }
  return *curves_;
}

/// Plans a path in cell coordinates.
PlanResult SmacHybridPlanner::planIn(const Costmap& given, const PlanRequest& request) {
  const HybridMotion motion(parameters_, given.resolution(), distro_);
  const Pose2 start = inCells(given, request.start);
  Costmap costmap = given;
  const std::vector<Pose2> goals = goalsAt(motion, inCells(given, request.goal));
  if (distro_ != Distro::Humble) {
    costmap.set(cellUnder(start), kFreeSpace);
  }
  const HybridSearch::Context context{
      parameters_, distro_, motion, costmap, request, obstacles_, curvesFor(motion, costmap)};
  HybridSearch search(context);
  if (distro_ == Distro::Humble && !search.costAt(start)) {
    return hybridFailure(PlanError::StartOccupied);
  }
  const auto isFree = [&](const Pose2& goal) { return search.costAt(goal).has_value(); };
  if (parameters_.tolerance / costmap.resolution() < kNoHybridTolerance &&
      std::none_of(goals.begin(), goals.end(), isFree)) {
    return hybridFailure(PlanError::GoalOccupied);
  }
  if (cellUnder(start) == cellUnder(goals.front()) &&
      motion.nearestBin(start.heading) == motion.nearestBin(goals.front().heading)) {
    return {PlanError::None, {{start.position, request.goal.heading}}, 0};
  }
  ObstacleHeuristic::Settings settings;
  settings.costPenalty = parameters_.costPenalty;
  settings.isQuadratic = distro_ != Distro::Humble && parameters_.useQuadraticCostPenalty;
  settings.allowUnknown = parameters_.allowUnknown;
  settings.isDownsampled = parameters_.downsampleObstacleHeuristic || distro_ == Distro::Humble;
  obstacles_.start(costmap, cellUnder(goals.front()), settings, parameters_.cacheObstacleHeuristic);
  return search.find(start, goals);
}

}  // namespace sim2d::nav2
