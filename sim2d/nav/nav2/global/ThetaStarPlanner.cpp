#include "sim2d/nav/nav2/global/ThetaStarPlanner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/OpenList.h"

namespace sim2d::nav2 {
namespace {

constexpr double kMaxSafeCost = 252.0;    // limit of cell costs, and of c' on a line
constexpr double kUnknownOnLine = 253.0;  // c' of a cell of 255 on a line

/// Sums the costs of the cells of a line.
class LineCost {
 public:
  LineCost(const Costmap& costmap, const ThetaStarCosts& costs)
      : costmap_(costmap), costs_(costs) {}

  double sum() const { return sum_; }
  bool isSafe(Cell cell) const { return costs_.isSafe[costmap_.at(cell)]; }

  /// Adds the cost of a cell; false if the cell blocks the line. The index wraps around.
  bool add(int column, int row) {
    const std::uint32_t index =
        static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(costmap_.width()) +
        static_cast<std::uint32_t>(column);
    if (index >= costmap_.costs().size()) {
      return false;
    }
    const std::uint8_t cost = costmap_.costs()[index];
    if (!costs_.isClear[cost]) {
      return false;
    }
    sum_ += costs_.lineCosts[cost];
    return true;
  }

 private:
  const Costmap& costmap_;
  const ThetaStarCosts& costs_;
  double sum_ = 0.0;
};

/// One axis of a line: begin, end, direction, and the offset of the cell next to a corner.
struct LineAxis {
  LineAxis(int from, int to)
      : begin(from),
        end(to),
        length(std::abs(to - from)),
        step(to > from ? 1 : -1),
        cornerOffset(to > from ? 0 : -1) {}

  int begin, end, length, step, cornerOffset;
};

/// The line of Humble to Kilted along its longer axis; `add(along, across)` is false if blocked.
template <class Add>
bool followCorners(const LineAxis& along, const LineAxis& across, const Add& add) {
  int error = 0, side = across.begin;
  for (int place = along.begin; place != along.end; place += along.step) {
    error += across.length;
    if (error >= along.length) {
      if (!add(place + along.cornerOffset, side + across.cornerOffset)) {
        return false;
      }
      side += across.step;
      error -= along.length;
    }
    if (error != 0 && !add(place + along.cornerOffset, side + across.cornerOffset)) {
      return false;
    }
    if (across.length == 0 && !add(place + along.cornerOffset, side) &&
        !add(place + along.cornerOffset, side - 1)) {
      return false;
    }
  }
  return true;
}

bool followCorners(const LineAxis& x, const LineAxis& y, LineCost& line) {
  if (x.length >= y.length) {
    return followCorners(x, y, [&](int along, int across) { return line.add(along, across); });
  }
  return followCorners(y, x, [&](int along, int across) { return line.add(across, along); });
}

bool followCells(const LineAxis& x, const LineAxis& y, LineCost& line) {
  int error = x.length - y.length;
  for (Cell cell{x.begin, y.begin}; cell != Cell{x.end, y.end};) {
    if (!line.add(cell.column, cell.row)) {
      return false;
    }
    const bool stepsX = 2 * error > -y.length, stepsY = 2 * error <= x.length;
    if (stepsX && stepsY &&
        !(line.isSafe({cell.column + x.step, cell.row}) &&
          line.isSafe({cell.column, cell.row + y.step}))) {
      return false;
    }
    if (stepsX) {
      error -= y.length;
      cell.column += x.step;
    }
    if (stepsY) {
      error += x.length;
      cell.row += y.step;
    }
  }
  return true;
}

}  // namespace

ThetaStarCosts::ThetaStarCosts(const ThetaStarParameters& parameters) {
  const auto traversal = [&](double weighed) {  // in Nav2's order of operations
    return parameters.traversalCost * weighed * weighed / kMaxSafeCost / kMaxSafeCost;
  };
  for (std::size_t cost = 0; cost < stepCosts.size(); ++cost) {
    const bool isUnknown = cost == kNoInformation;
    const double weighed = 26.0 + 0.9 * static_cast<double>(cost);  // c'
    stepCosts[cost] = traversal(weighed);
    lineCosts[cost] = traversal(isUnknown ? kUnknownOnLine : weighed);
    isSafe[cost] = isUnknown ? parameters.allowUnknown : static_cast<double>(cost) <= kMaxSafeCost;
    isClear[cost] = isUnknown ? parameters.allowUnknown : weighed <= kMaxSafeCost;
  }
}

std::optional<double> thetaStarLineCost(const Costmap& costmap, const ThetaStarCosts& costs,
                                        Distro distro, Cell from, Cell to) {
  const LineAxis x(from.column, to.column), y(from.row, to.row);
  LineCost line(costmap, costs);
  const bool isFree =
      distro >= Distro::Lyrical ? followCells(x, y, line) : followCorners(x, y, line);
  return isFree ? std::optional<double>(line.sum()) : std::nullopt;
}

double hypotAsGlibc(double x, double y) {
  const double large = std::max(std::fabs(x), std::fabs(y));
  const double small = std::min(std::fabs(x), std::fabs(y));
  constexpr double kNegligible = 0x1p-54;
  if (small <= large * kNegligible) {
    return large + small;
  }
  const double root = std::sqrt(large * large + small * small);
  double first = 0.0, second = 0.0;  // terms of the negated remainder large^2 + small^2 - root^2
  if (root <= 2.0 * small) {
    const double delta = root - small;
    first = large * (2.0 * delta - large);
    second = (delta - 2.0 * (large - small)) * delta;
  } else {
    const double delta = root - large;
    first = 2.0 * delta * (large - 2.0 * small);
    second = (4.0 * delta - small) * small + delta * delta;
  }
  return root - (first + second) / (2.0 * root);
}

namespace {

constexpr Cell kThetaMoves[] = {{0, 1},  {0, -1}, {1, 0}, {-1, 0},
                                {1, -1}, {-1, 1}, {1, 1}, {-1, -1}};

/// nav2_theta_star_planner::ThetaStarPlanner: lazy Theta*. A node is first reached from a
/// neighbour; when it is expanded, its parent's parent is tried along a line of sight. A step costs
/// w_euc |step| + w_traversal (c'/252)^2 and the estimate is min(1, w_euc) times the distance to
/// the goal, lengths in cells. Headings within the path are 0.
///
/// As in Nav2 the search fails when its queue becomes empty, even if the last popped node is the
/// goal: a corridor one cell wide has no path. Since an improved node keeps its place in the heap,
/// the path is not always the cheapest.
class ThetaStarPlanner final : public GlobalPlanner {
 public:
  ThetaStarPlanner(const ThetaStarParameters& parameters, Distro distro)
      : parameters_(parameters), distro_(distro), costs_(parameters) {}

  PlanResult plan(const PlanRequest& request) override {
    if (auto result =
            planWithoutSearch(request, request.costmap, parameters_.useFinalApproachOrientation)) {
      return *std::move(result);
    }
    PlanResult result;
    costmap_ = request.costmap;
    const Cell start = *costmap_.worldToCell(request.start.position);
    goal_ = *costmap_.worldToCell(request.goal.position);
    costmap_.set(start, kFreeSpace);
    if (!isSafe(goal_)) {
      result.error = PlanError::GoalOccupied;
    } else if (!search(start, result, request.stop)) {
      result.error = PlanError::NoValidPath;
    } else {
      result.path = backtrace(request);
    }
    return result;
  }

 private:
  struct Node {
    double g = 0.0, f = 0.0;  // cost so far; with the estimate
    int parent = -1;          // index of a cell; the start is its own parent
    bool isQueued = false;
  };

  bool isSafe(Cell cell) const { return costs_.isSafe[costmap_.at(cell)]; }
  Cell cellAt(int index) const { return costmap_.cellOf(static_cast<std::size_t>(index)); }
  double keyOf(std::size_t index) const { return nodes_[index].f; }

  double lengthCost(Cell from, Cell to) const {
    return parameters_.eucCost * hypotAsGlibc(from.column - to.column, from.row - to.row);
  }

  double estimate(Cell cell) const {
    return std::min(1.0, parameters_.eucCost) *
           hypotAsGlibc(cell.column - goal_.column, cell.row - goal_.row);
  }

  /// As in Nav2 the start is expanded twice: it is queued and also expanded first.
  bool search(Cell start, PlanResult& result, const base::StopFlag* stop) {
    Node unseen;
    unseen.f = std::numeric_limits<double>::max();
    nodes_.assign(costmap_.costs().size(), unseen);
    queue_.clear();
    const auto keys = [this](std::size_t index) { return keyOf(index); };
    const std::size_t first = costmap_.indexOf(start), last = costmap_.indexOf(goal_);
    const double g = costs_.stepCosts[costmap_.at(start)];
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
      tryGrandparent(static_cast<int>(current));
      expand(static_cast<int>(current));
      current = queue_.pop(keys);
    }
    return false;
  }

  /// Replaces a node's parent by its grandparent if there is a cheaper line of sight.
  void tryGrandparent(int index) {
    Node& node = nodes_[static_cast<std::size_t>(index)];
    node.isQueued = false;
    const int grandparent = nodes_[static_cast<std::size_t>(node.parent)].parent;
    const Cell cell = cellAt(index), from = cellAt(grandparent);
    const auto line = thetaStarLineCost(costmap_, costs_, distro_, cell, from);
    if (!line) {
      return;
    }
    const double g =
        nodes_[static_cast<std::size_t>(grandparent)].g + lengthCost(cell, from) + *line;
    if (g < node.g) {
      node.g = g;
      node.f = g + estimate(cell);
      node.parent = grandparent;
    }
  }

  void expand(int index) {
    const Cell cell = cellAt(index);
    const double g = nodes_[static_cast<std::size_t>(index)].g;
    for (int i = 0; i < parameters_.howManyCorners; ++i) {
      const Cell next{cell.column + kThetaMoves[i].column, cell.row + kThetaMoves[i].row};
      if (!costmap_.contains(next) || !isSafe(next)) {
        continue;
      }
      const double found = g + lengthCost(cell, next) + costs_.stepCosts[costmap_.at(next)];
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

  /// The path with poses at the nodes and at each cell length between them.
  Path backtrace(const PlanRequest& request) const {
    std::vector<Vec2> corners;
    for (int index = static_cast<int>(costmap_.indexOf(goal_));;) {
      corners.push_back(costmap_.cellToWorld(cellAt(index)));
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
      setFinalApproachHeading(path, request.start.heading);
    }
    return path;
  }

  ThetaStarParameters parameters_;
  Distro distro_;
  ThetaStarCosts costs_;
  Costmap costmap_;
  Cell goal_;
  std::vector<Node> nodes_;
  StaleHeap queue_;
};

}  // namespace

PlannerPointer makeGlobalPlanner(const ThetaStarParameters& parameters, Distro distro) {
  return std::make_unique<ThetaStarPlanner>(parameters, distro);
}

}  // namespace sim2d::nav2
