#include "sim2d/nav/nav2/global/Smac2DPlanner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/SmacCommon.h"

namespace sim2d::nav2 {
namespace {

constexpr float kDiagonal = 1.41421356F;
constexpr std::size_t kMinSmoothedPlan = 7;  // poses
constexpr double kNoTolerance = 1e-3;        // [cells]

constexpr Cell kSmacMoves[] = {{-1, 0},  {1, 0},  {0, -1}, {0, 1},
                               {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};

}  // namespace

Smac2DPlanner::Smac2DPlanner(const Smac2DParameters& parameters, Distro distro)
    : parameters_(parameters), distro_(distro) {}

PlanResult Smac2DPlanner::plan(const PlanRequest& request) {
  PlanResult result;
  const int factor = parameters_.downsampleCostmap ? parameters_.downsamplingFactor : 1;
  costmap_ = downsampled(request.costmap, factor, false);
  const auto start = costmap_.worldToCell(request.start.position);
  const auto goal = costmap_.worldToCell(request.goal.position);
  if (!start || !goal) {
    result.error = start ? PlanError::GoalOutsideMap : PlanError::StartOutsideMap;
    return result;
  }
  goal_ = *goal;
  if (*start == *goal) {
    if (costmap_.at(*start) == kLethal) {
      result.error = PlanError::StartOccupied;
    } else {
      result.path = {
          singlePose(request.start, request.goal, parameters_.useFinalApproachOrientation)};
    }
    return result;
  }
  if (distro_ != Distro::Humble) {
    costmap_.set(*start, kFreeSpace);
  } else if (!isSmacFree(costmap_.at(*start), parameters_.allowUnknown)) {
    result.error = PlanError::StartOccupied;
    return result;
  }
  if (toleranceInCells() < kNoTolerance &&
      !isSmacFree(costmap_.at(*goal), parameters_.allowUnknown)) {
    result.error = PlanError::GoalOccupied;
    return result;
  }
  search(*start, result, request.stop);
  if (result.error == PlanError::None) {
    finish(request, result.path);
  }
  return result;
}

Cell Smac2DPlanner::cellOf(std::size_t index) const {
  const auto width = static_cast<std::size_t>(costmap_.width());
  return {static_cast<int>(index % width), static_cast<int>(index / width)};
}

float Smac2DPlanner::estimate(Cell cell) const {
  const double dx = goal_.column - cell.column, dy = goal_.row - cell.row;
  return static_cast<float>(std::sqrt(dx * dx + dy * dy));
}

void Smac2DPlanner::search(Cell start, PlanResult& result, const base::StopFlag* stop) {
  const SmacLimits limits = smacLimits(parameters_, parameters_.maxPlanningTime, kSmac2DPerSecond);
  Node unseen;
  unseen.g = std::numeric_limits<float>::max();
  nodes_.assign(costmap_.costs().size(), unseen);
  open_.clear();
  nearest_ = {};
  const std::size_t first = costmap_.indexOf(start), last = costmap_.indexOf(goal_);
  nodes_[first].g = 0.0F;
  open_.push(0.0F, first);
  int nearGoal = 0;
  while (!open_.isEmpty() && result.iterations < limits.most) {
    const std::size_t index = open_.pop().node;
    if (nodes_[index].isVisited) {
      continue;
    }
    if (stop != nullptr && result.iterations % limits.checkInterval == 0) {
      stop->check();
    }
    ++result.iterations;
    nodes_[index].isVisited = true;
    if (index == last) {
      return collect(index, result.path);
    }
    if (nearest_.estimate < toleranceInCells() && ++nearGoal >= limits.maxOnApproach) {
      return collect(nearest_.node, result.path);
    }
    expand(index);
  }
  if (nearest_.estimate < toleranceInCells()) {
    return collect(nearest_.node, result.path);
  }
  result.error = result.iterations < limits.most ? PlanError::NoValidPath : PlanError::Timeout;
}

void Smac2DPlanner::expand(std::size_t index) {
  const Cell cell = cellOf(index);
  for (const Cell& move : kSmacMoves) {
    const Cell next{cell.column + move.column, cell.row + move.row};
    if (!costmap_.contains(next) || !isSmacFree(costmap_.at(next), parameters_.allowUnknown)) {
      continue;
    }
    const std::size_t at = costmap_.indexOf(next);
    if (nodes_[at].isVisited) {
      continue;
    }
    // Uses Nav2's types so that paths of equal cost stay equal.
    const double length = move.column != 0 && move.row != 0 ? kDiagonal : 1.0F;
    const auto share = static_cast<float>(costmap_.at(next) / kSmacMaxCost);
    const float price = static_cast<float>(parameters_.costTravelMultiplier) * share;
    const float g = nodes_[index].g + static_cast<float>(length * (1.0 + price));
    if (g < nodes_[at].g) {
      nodes_[at].g = g;
      nodes_[at].parent = static_cast<std::int32_t>(index);
      const float toGo = estimate(next);
      nearest_.offer(toGo, at);
      open_.push(g + toGo, at);
    }
  }
}

void Smac2DPlanner::collect(std::size_t end, Path& path) const {
  for (auto index = static_cast<std::int32_t>(end); index >= 0;
       index = nodes_[static_cast<std::size_t>(index)].parent) {
    path.push_back({costmap_.cellToWorld(cellOf(static_cast<std::size_t>(index))), 0.0});
  }
  std::reverse(path.begin(), path.end());
}

void Smac2DPlanner::finish(const PlanRequest& request, Path& path) const {
  if (path.size() >= kMinSmoothedPlan) {
    smoothSmacPath(path, parameters_, request.costmap, std::nullopt);
  }
  path.back().heading = request.goal.heading;
  if (parameters_.useFinalApproachOrientation) {
    setFinalApproachHeading(path, request.start.heading);
  }
}

}  // namespace sim2d::nav2
