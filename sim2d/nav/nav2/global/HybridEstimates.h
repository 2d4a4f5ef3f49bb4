#pragma once

#include <cstdint>
#include <vector>

#include "sim2d/nav/nav2/global/OpenList.h"
#include "sim2d/nav/nav2/global/ShortestCurve.h"

/// What a way to the goal costs at least: the two heuristics of Smac Hybrid-A*. Lengths in cells.
namespace sim2d::nav2 {

/// Round obstacles, for a body without a heading: Dijkstra from the goal over eight neighbours,
/// spread only as far as asked. A step costs L (1 + cost_penalty c / 252).
class ObstacleDistance {
 public:
  struct Settings {
    double costPenalty = 2.0;
    bool isQuadratic = false;  // (c / 252)^2
    bool allowUnknown = true;
    bool isDownsampled = true;  // half as many cells each way, with the least of four costs
  };
  /// `keepsOld`: what is known of the same goal on a map of that size stays, although the costs may
  /// have changed (`cache_obstacle_heuristic`).
  void start(const Costmap& costmap, Cell goal, const Settings& settings, bool keepsOld);

  /// 0 where no way leads from; the cell lies in the map.
  double from(Cell cell);

 private:
  void settleNext();

  Settings settings_;
  Costmap costmap_;
  int factor_ = 1;
  Cell goal_{-1, -1};
  int width_ = 0, height_ = 0;  // of the map as given
  std::vector<double> distance_;
  std::vector<char> isSettled_;
  OpenList<double> open_;
};

/// Through an empty plane, for the car: lengths of shortest curves from the cells of a square about
/// the goal and headings in bins, worked out when first asked for.
class CurveDistance {
 public:
  CurveDistance(CarMotion motion, double turningRadius, int bins, int side);

  /// Of a place and heading seen from the goal [cells], [bins]; rounded to whole ones. Outside the
  /// square: 0.
  double from(const Vec2& inGoal, int bin);

 private:
  CarMotion motion_;
  double radius_;
  int bins_, half_;
  std::vector<std::int32_t> blockOf_;  // per place with y >= 0: where its bins lie; -1: nowhere yet
  std::vector<float> lengths_;         // negative: not yet known
};

}  // namespace sim2d::nav2
