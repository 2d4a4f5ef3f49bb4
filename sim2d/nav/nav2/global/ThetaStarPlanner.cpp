#include "sim2d/nav/nav2/global/ThetaStarPlanner.h"

#include <algorithm>
#include <limits>

#include "sim2d/nav/nav2/global/PathEnds.h"

namespace sim2d::nav2 {
namespace {

constexpr Cell kThetaMoves[] = {{0, 1},  {0, -1}, {1, 0}, {-1, 0},
                                {1, -1}, {-1, 1}, {1, 1}, {-1, -1}};

}  // namespace

ThetaStarPlanner::ThetaStarPlanner(const ThetaStarParameters& parameters, Distro distro)
    : parameters_(parameters), distro_(distro), costs_(parameters) {}

PlanResult ThetaStarPlanner::plan(const PlanRequest& request) {
  const auto start = request.costmap.worldToCell(request.start.position);
  const auto goal = request.costmap.worldToCell(request.goal.position);
  PlanResult result;
  if (!start || !goal) {
    result.error = start ? PlanError::GoalOutsideMap : PlanError::StartOutsideMap;
    return result;
  }
  costmap_ = request.costmap;
  goal_ = *goal;
  if (*start == *goal) {
    if (costmap_.at(*start) == kLethal) {
      result.error = PlanError::StartOccupied;
    } else {
      result.path = {
          poseOnTheSpot(request.start, request.goal, parameters_.useFinalApproachOrientation)};
    }
    return result;
  }
  costmap_.set(*start, kFreeSpace);
  if (!isSafe(*goal)) {
    result.error = PlanError::GoalOccupied;
  } else if (!search(*start, result, request.stop)) {
    result.error = PlanError::NoValidPath;
  } else {
    result.path = pathBack(request);
  }
  return result;
}

double ThetaStarPlanner::lengthCost(Cell from, Cell to) const {
  return parameters_.eucCost * hypotAsGlibc(from.column - to.column, from.row - to.row);
}

double ThetaStarPlanner::estimate(Cell cell) const {
  return std::min(1.0, parameters_.eucCost) *
         hypotAsGlibc(cell.column - goal_.column, cell.row - goal_.row);
}

/// The start is expanded twice, as in Nav2: it is in the queue and the first one to be looked at.
bool ThetaStarPlanner::search(Cell start, PlanResult& result, const base::StopFlag* stop) {
  Node unseen;
  unseen.f = std::numeric_limits<double>::max();
  nodes_.assign(costmap_.costs().size(), unseen);
  queue_.clear();
  const auto keys = [this](std::size_t index) { return keyOf(index); };
  const std::size_t first = costmap_.indexOf(start), last = costmap_.indexOf(goal_);
  const double g = costs_.entered[costmap_.at(start)];
  nodes_[first] = {g, g + estimate(start), static_cast<int>(first), true};
  queue_.push(first, keys);
  std::size_t current = first;
  while (!queue_.isEmpty()) {
    if (stop != nullptr && result.iterations % parameters_.terminalCheckingInterval == 0) {
      stop->check();
    }
    ++result.iterations;
    if (current == last) {
      return true;
    }
    retryParent(static_cast<int>(current));
    expand(static_cast<int>(current));
    current = queue_.pop(keys);
  }
  return false;
}

/// Attaches a node to its parent's parent if a straight line leads there and costs less.
void ThetaStarPlanner::retryParent(int index) {
  Node& node = nodes_[static_cast<std::size_t>(index)];
  node.isQueued = false;
  const int grandparent = nodes_[static_cast<std::size_t>(node.parent)].parent;
  const Cell cell = cellOf(index), from = cellOf(grandparent);
  const auto line = thetaStarLine(costmap_, costs_, distro_, cell, from);
  if (!line) {
    return;
  }
  const double g = nodes_[static_cast<std::size_t>(grandparent)].g + lengthCost(cell, from) + *line;
  if (g < node.g) {
    node.g = g;
    node.f = g + estimate(cell);
    node.parent = grandparent;
  }
}

void ThetaStarPlanner::expand(int index) {
  const Cell cell = cellOf(index);
  const double g = nodes_[static_cast<std::size_t>(index)].g;
  for (int i = 0; i < parameters_.howManyCorners; ++i) {
    const Cell next{cell.column + kThetaMoves[i].column, cell.row + kThetaMoves[i].row};
    if (!costmap_.contains(next) || !isSafe(next)) {
      continue;
    }
    const double found = g + lengthCost(cell, next) + costs_.entered[costmap_.at(next)];
    const double whole = found + estimate(next);
    Node& node = nodes_[costmap_.indexOf(next)];
    if (node.f > whole) {
      node.g = found;
      node.f = whole;
      node.parent = index;
      if (!node.isQueued) {
        node.isQueued = true;
        queue_.push(costmap_.indexOf(next), [this](std::size_t each) { return keyOf(each); });
      }
    }
  }
}

/// Poses at the nodes and every cell's length between them.
Path ThetaStarPlanner::pathBack(const PlanRequest& request) const {
  std::vector<Vec2> corners;
  for (int index = static_cast<int>(costmap_.indexOf(goal_));;) {
    corners.push_back(costmap_.cellToWorld(cellOf(index)));
    const int parent = nodes_[static_cast<std::size_t>(index)].parent;
    if (parent == index) {
      break;
    }
    index = parent;
  }
  Path path;
  for (std::size_t i = corners.size() - 1; i > 0; --i) {
    const Vec2 way = corners[i - 1] - corners[i];
    const double length = hypotAsGlibc(way.x(), way.y());
    path.push_back({corners[i], 0.0});
    const int pieces = static_cast<int>(length / costmap_.resolution());
    for (int k = 1; k < pieces; ++k) {
      path.push_back({corners[i] + k * costmap_.resolution() * (way / length), 0.0});
    }
  }
  path.push_back({corners.front(), request.goal.heading});
  if (parameters_.useFinalApproachOrientation) {
    faceAlongPath(path, request.start.heading);
  }
  return path;
}

}  // namespace sim2d::nav2
