#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/OpenList.h"
#include "sim2d/nav/nav2/global/SmacCommon.h"

namespace sim2d::nav2 {
namespace {

constexpr float kDiagonal = 1.41421356F;
constexpr std::size_t kMinSmoothedPlan = 7;  // poses
constexpr double kNoTolerance = 1e-3;        // [cells]

constexpr Cell kSmacMoves[] = {{-1, 0},  {1, 0},  {0, -1}, {0, 1},
                               {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};

/// nav2_smac_planner::SmacPlanner2D: A* over cells and their eight neighbours; a step costs L (1 +
/// cost_travel_multiplier c / 252), L = 1 or sqrt 2. Smooths its path.
class Smac2DPlanner final : public GlobalPlanner {
 public:
  Smac2DPlanner(const Smac2DParameters& parameters, Distro distro)
      : parameters_(parameters), distro_(distro) {}

  PlanResult plan(const PlanRequest& request) override {
    const int factor = parameters_.downsampleCostmap ? parameters_.downsamplingFactor : 1;
    costmap_ = downsampled(request.costmap, factor, false);
    if (auto result =
            planWithoutSearch(request, costmap_, parameters_.useFinalApproachOrientation)) {
      return *std::move(result);
    }
    PlanResult result;
    const Cell start = *costmap_.worldToCell(request.start.position);
    goal_ = *costmap_.worldToCell(request.goal.position);
    if (distro_ != Distro::Humble) {
      costmap_.set(start, kFreeSpace);
    } else if (!isFree(start)) {
      result.error = PlanError::StartOccupied;
      return result;
    }
    if (toleranceInCells() < kNoTolerance && !isFree(goal_)) {
      result.error = PlanError::GoalOccupied;
      return result;
    }
    search(start, result, request.stop);
    if (result.error == PlanError::None) {
      finish(request, result.path);
    }
    return result;
  }

 private:
  struct Node {
    float g = 0.0F;  // cost so far
    std::int32_t parent = -1;
    bool isVisited = false;
  };

  bool isFree(Cell cell) const { return isSmacFree(costmap_.at(cell), parameters_.allowUnknown); }
  double toleranceInCells() const { return parameters_.tolerance / costmap_.resolution(); }

  float estimate(Cell cell) const {
    const double dx = goal_.column - cell.column, dy = goal_.row - cell.row;
    return static_cast<float>(std::sqrt(dx * dx + dy * dy));
  }

  void search(Cell start, PlanResult& result, const base::StopFlag* stop) {
    const SmacLimits limits =
        smacLimits(parameters_, parameters_.maxPlanningTime, kSmac2DPerSecond);
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

  void expand(std::size_t index) {
    const Cell cell = costmap_.cellOf(index);
    for (const Cell& move : kSmacMoves) {
      const Cell next{cell.column + move.column, cell.row + move.row};
      if (!costmap_.contains(next) || !isFree(next)) {
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

  void collect(std::size_t end, Path& path) const {
    for (auto index = static_cast<std::int32_t>(end); index >= 0;
         index = nodes_[static_cast<std::size_t>(index)].parent) {
      path.push_back({costmap_.cellToWorld(costmap_.cellOf(static_cast<std::size_t>(index))), 0.0});
    }
    std::reverse(path.begin(), path.end());
  }

  void finish(const PlanRequest& request, Path& path) const {
    if (path.size() >= kMinSmoothedPlan) {
      smoothSmacPath(path, parameters_, request.costmap, std::nullopt);
    }
    path.back().heading = request.goal.heading;
    if (parameters_.useFinalApproachOrientation) {
      setFinalApproachHeading(path, request.start.heading);
    }
  }

  Smac2DParameters parameters_;
  Distro distro_;
  Costmap costmap_;
  Cell goal_;
  std::vector<Node> nodes_;
  OpenList<float> open_;
  NearestNode nearest_;
};

}  // namespace

PlannerPointer makeGlobalPlanner(const Smac2DParameters& parameters, Distro distro) {
  return std::make_unique<Smac2DPlanner>(parameters, distro);
}

}  // namespace sim2d::nav2
