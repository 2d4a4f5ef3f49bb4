#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/nav/nav2/global/HybridEstimates.h"
#include "sim2d/nav/nav2/global/HybridMotion.h"
#include "sim2d/nav/nav2/global/SmacGrid.h"

namespace sim2d::nav2 {

/// One search of Smac Hybrid-A*. Places in cells of the costmap, (0, 0) is its lower left corner.
class HybridSearch {
 public:
  /// All must outlive the search; `costmap` is that of the search, at its resolution.
  struct Setting {
    const SmacHybridParameters& parameters;
    Distro distro;
    const HybridMotion& motion;
    const Costmap& costmap;
    const PlanRequest& request;  // whose footprint and stop flag count
    ObstacleDistance& obstacles;
    CurveDistance& curves;
  };
  explicit HybridSearch(const Setting& setting);

  /// Whether the robot can be there; the cost of its cell if so.
  std::optional<std::uint8_t> costAt(const Pose2& pose) const;

  /// The goals lie at one place; headings are multiples of the bin. Poses from the start to a goal,
  /// or as near as the tolerance allows.
  PlanResult find(const Pose2& start, const std::vector<Pose2>& goals);

 private:
  struct Node {
    Pose2 pose;  // heading = bin times bin size
    double g = 0.0;
    int bin = 0;
    int step = -1;  // the one that led here; -1: start
    int parent = -1;
    std::uint8_t cost = 0;
    bool isVisited = false;
  };
  struct Expansion {  // when the next curve to the goal is tried
    int due = 0;
    int closest = 1 << 30;  // least estimate so far [cells]
  };

  void begin(const Pose2& start, const std::vector<Pose2>& goals);
  int nodeAt(const Vec2& place, int bin);
  bool isInside(const Vec2& place) const;
  double estimate(const Node& node);
  void expand(int index);
  void enter(int from, std::size_t step);
  std::optional<Path> wayToGoal(int index);
  std::optional<Path> curveToGoal(int index);
  std::optional<Path> curveFrom(const Node& node, const Pose2& goal) const;
  bool isTooCostly(const std::vector<std::uint8_t>& costs, double length) const;
  std::optional<Path> shortestToGoals(const Node& node, const Pose2*& goal) const;
  double curveLength(const Node& node, const Pose2& goal) const;
  const Node* ancestorOf(const Node& node) const;
  Path pathTo(int index) const;

  Setting setting_;
  std::vector<Pose2> goals_;
  std::vector<int> goalNodes_;
  std::vector<Node> nodes_;
  std::vector<std::int32_t> blockOf_;  // per cell: where its bins lie in `slots_`; -1: nowhere yet
  std::vector<std::int32_t> slots_;    // per cell and bin: its node; -1: none yet
  OpenList<double> open_;
  SmacNearest nearest_;
  Expansion expansion_;
};

}  // namespace sim2d::nav2
