#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/OpenList.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"
#include "sim2d/nav/nav2/global/ShortestCurve.h"

/// Helpers shared by the Smac planners.
namespace sim2d::nav2 {

constexpr double kSmacMaxCost = 252.0;  // normalizes costs to 1 beside collisions

/// Whether a cell is free for the centre of a round robot.
constexpr bool isSmacFree(std::uint8_t cost, bool allowUnknown) {
  return cost == kNoInformation ? allowUnknown : cost < kInscribed;
}

/// Merges `factor` x `factor` cells into one with their maximum or minimum cost.
Costmap downsampled(const Costmap& costmap, int factor, bool takesLeast);

/// Search limits in iterations.
struct SmacLimits {
  int most = 0, maxOnApproach = 0, checkInterval = 0;
};
SmacLimits smacLimits(const SmacParameters& parameters, double maxPlanningTime, double perSecond);

/// The node with the minimum estimate to the goal, for the tolerance.
struct NearestNode {
  double estimate = 1e30;  // heuristic [cells]
  std::size_t node = 0;

  void offer(double nodeEstimate, std::size_t index) {
    if (nodeEstimate < estimate) {
      estimate = nodeEstimate;
      node = index;
    }
  }
};

/// The two heuristics of Smac Hybrid-A*: lower bounds of the cost to the goal. Lengths in cells.

/// Obstacle heuristic for a point robot: Dijkstra from the goal over eight neighbours, expanded
/// only as far as requested. A step costs L (1 + cost_penalty c / 252).
class ObstacleHeuristic {
 public:
  struct Settings {
    double costPenalty = 2.0;
    bool isQuadratic = false;  // (c / 252)^2
    bool allowUnknown = true;
    bool isDownsampled = true;  // half the resolution, with the minimum of four costs
  };
  /// `keepsCache`: keeps the distances for the same goal on a map of the same size although the
  /// costs may have changed (`cache_obstacle_heuristic`).
  void start(const Costmap& costmap, Cell goal, const Settings& settings, bool keepsCache);

  /// 0 if the goal is not reachable; precondition: the cell is in the map.
  double from(Cell cell);

 private:
  void settleNext();

  Settings settings_;
  Costmap costmap_;
  int factor_ = 1;
  Cell goal_{-1, -1};
  int width_ = 0, height_ = 0;  // of the given map
  std::vector<double> distance_;
  std::vector<char> isSettled_;
  OpenList<double> open_;
};

/// Distance heuristic for the car without obstacles: lengths of shortest curves from the cells of a
/// square around the goal for each heading bin, computed on first use.
class DistanceHeuristic {
 public:
  DistanceHeuristic(CarMotion motion, double turningRadius, int bins, int side);

  /// For a position and heading in the goal's frame [cells], [bins], rounded to integers. 0 outside
  /// the square.
  double from(const Vec2& inGoal, int bin);

 private:
  CarMotion motion_;
  double radius_;
  int bins_, half_;
  std::vector<std::int32_t> blockOf_;  // per position with y >= 0: index of its bins; -1: none yet
  std::vector<float> lengths_;         // negative: not computed yet
};

/// The car that must be able to follow the smoothed path.
struct CarModel {
  CarMotion motion = CarMotion::Dubins;
  double turningRadius = 0.4;  // R [m]
};

/// The smoother of the Smac planners: sweeps, and for a car also drivable curves from the start and
/// to the end of each segment. Its time limit is a limit of sweeps.
void smoothSmacPath(Path& path, const SmacParameters& parameters, const Costmap& costmap,
                    const std::optional<CarModel>& car);

}  // namespace sim2d::nav2
