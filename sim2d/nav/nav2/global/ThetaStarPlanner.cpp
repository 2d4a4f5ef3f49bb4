#include "sim2d/nav/nav2/global/ThetaStarPlanner.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "sim2d/nav/nav2/global/PathEnds.h"

namespace sim2d::nav2 {
namespace {

constexpr double kMostSafe = 252.0;       // of a cell's cost, and of c' on a line
constexpr double kUnknownOnLine = 253.0;  // c' of a cell of 255 there

constexpr Cell kThetaMoves[] = {{0, 1},  {0, -1}, {1, 0}, {-1, 0},
                                {1, -1}, {-1, 1}, {1, 1}, {-1, -1}};

}  // namespace

ThetaStarPlanner::ThetaStarPlanner(const ThetaStarParameters& parameters)
    : parameters_(parameters) {
  const auto traversal = [&](double weighedCost) {
    const double share = weighedCost / kMostSafe;
    return parameters.traversalCost * share * share;
  };
  for (std::size_t cost = 0; cost < entered_.size(); ++cost) {
    const bool isUnknown = cost == kNoInformation;
    const double weighed = 26.0 + 0.9 * static_cast<double>(cost);  // c'
    entered_[cost] = traversal(weighed);
    seen_[cost] = traversal(isUnknown ? kUnknownOnLine : weighed);
    isSafe_[cost] = isUnknown ? parameters.allowUnknown : static_cast<double>(cost) <= kMostSafe;
    isClear_[cost] = isUnknown ? parameters.allowUnknown : weighed <= kMostSafe;
  }
}

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
    if (cost(*start) == kLethal) {
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

int ThetaStarPlanner::cost(Cell cell) const {
  return costmap_.at(cell);
}

bool ThetaStarPlanner::isSafe(Cell cell) const {
  return isSafe_[static_cast<std::size_t>(cost(cell))];
}

double ThetaStarPlanner::lengthCost(Cell from, Cell to) const {
  const double dx = to.column - from.column, dy = to.row - from.row;
  return parameters_.eucCost * std::sqrt(dx * dx + dy * dy);
}

double ThetaStarPlanner::estimate(Cell cell) const {
  const double dx = goal_.column - cell.column, dy = goal_.row - cell.row;
  return std::min(1.0, parameters_.eucCost) * std::sqrt(dx * dx + dy * dy);
}

/// False where the line must not go; else adds what the cell costs.
bool ThetaStarPlanner::addSeen(Cell cell, double& sum) const {
  const auto found = static_cast<std::size_t>(cost(cell));
  sum += seen_[found];
  return isClear_[found];
}

/// Cost of the cells between, the first with them and the last not; none without a line of sight.
std::optional<double> ThetaStarPlanner::lineCost(Cell from, Cell to) const {
  const int dx = std::abs(to.column - from.column), dy = std::abs(to.row - from.row);
  const int stepX = to.column > from.column ? 1 : -1, stepY = to.row > from.row ? 1 : -1;
  double sum = 0.0, beside = 0.0;
  int error = dx - dy;
  for (Cell cell = from; cell != to;) {
    if (!addSeen(cell, sum)) {
      return std::nullopt;
    }
    const int twice = 2 * error;
    const bool goesX = twice > -dy, goesY = twice < dx;
    if (goesX && goesY &&
        !(addSeen({cell.column + stepX, cell.row}, beside) &&
          addSeen({cell.column, cell.row + stepY}, beside))) {
      return std::nullopt;
    }
    if (goesX) {
      error -= dy;
      cell.column += stepX;
    }
    if (goesY) {
      error += dx;
      cell.row += stepY;
    }
  }
  return sum;
}

bool ThetaStarPlanner::search(Cell start, PlanResult& result, const base::StopFlag* stop) {
  Node unseen;
  unseen.f = std::numeric_limits<double>::infinity();
  nodes_.assign(costmap_.costs().size(), unseen);
  open_.clear();
  const auto first = costmap_.indexOf(start), last = costmap_.indexOf(goal_);
  const double g = entered_[static_cast<std::size_t>(cost(start))];
  nodes_[first] = {g, g + estimate(start), static_cast<int>(first)};
  open_.push(nodes_[first].f, first);
  while (!open_.isEmpty()) {
    const auto entry = open_.pop();
    if (entry.cost > nodes_[entry.node].f) {
      continue;  // has been improved and put in again since
    }
    if (stop != nullptr && result.iterations % parameters_.terminalCheckingInterval == 0) {
      stop->check();
    }
    ++result.iterations;
    if (entry.node == last) {
      return true;
    }
    retryParent(static_cast<int>(entry.node));
    expand(static_cast<int>(entry.node));
  }
  return false;
}

/// Hangs a node on its parent's parent when that is in sight and nearer.
void ThetaStarPlanner::retryParent(int index) {
  Node& node = nodes_[static_cast<std::size_t>(index)];
  const int grandparent = nodes_[static_cast<std::size_t>(node.parent)].parent;
  const Cell cell = cellOf(index), from = cellOf(grandparent);
  const auto line = lineCost(cell, from);
  if (!line) {
    return;
  }
  const double g = nodes_[static_cast<std::size_t>(grandparent)].g + lengthCost(cell, from) + *line;
  if (g < node.g) {
    node = {g, g + estimate(cell), grandparent};
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
    const double found =
        g + lengthCost(cell, next) + entered_[static_cast<std::size_t>(cost(next))];
    const double whole = found + estimate(next);
    Node& node = nodes_[costmap_.indexOf(next)];
    if (node.f > whole) {
      node = {found, whole, index};
      open_.push(whole, costmap_.indexOf(next));
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
    const double length = way.norm();
    path.push_back({corners[i], 0.0});
    const int pieces = static_cast<int>(length / costmap_.resolution());
    for (int k = 1; k < pieces; ++k) {
      path.push_back({corners[i] + k * costmap_.resolution() / length * way, 0.0});
    }
  }
  path.push_back({corners.front(), request.goal.heading});
  if (parameters_.useFinalApproachOrientation) {
    faceAlongPath(path, request.start.heading);
  }
  return path;
}

}  // namespace sim2d::nav2
