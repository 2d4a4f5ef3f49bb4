#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/nav/nav2/global/PlannerParameters.h"
#include "sim2d/nav/nav2/global/ShortestCurve.h"
#include "sim2d/nav/nav2/global/SmacCommon.h"

/// Motion primitives of Smac Hybrid-A* (nav2_smac_planner, node_hybrid.cpp). Lengths in cells,
/// headings in bins of 2 pi / `angle_quantization_bins`.
namespace sim2d::nav2 {

struct HybridStep {
  double dx = 0.0, dy = 0.0;  // [cells], in the frame of the start pose
  int bins = 0;               // heading change, counter-clockwise
  ShortestCurve::Turn turn = ShortestCurve::Turn::Straight;
  bool isBackward = false;
  double length = 0.0;  // L [cells]
};

/// The motion primitives of a car and their costs.
class HybridMotion {
 public:
  HybridMotion(const SmacHybridParameters& parameters, double cellSize, Distro distro);

  CarMotion car() const { return car_; }
  double turningRadius() const { return radius_; }  // R [cells], at least 1
  int bins() const { return bins_; }
  double binSize() const { return binSize_; }  // [rad]
  int nearestBin(double heading) const;
  int wrappedBin(int bin) const { return ((bin % bins_) + bins_) % bins_; }
  /// Straight, left, right, the same in reverse for Reeds-Shepp, then wider turns.
  const std::vector<HybridStep>& steps() const { return steps_; }
  /// Displacement of a step from a heading, world axes [cells].
  const Vec2& offset(std::size_t step, int bin) const {
    return offsets_[step * static_cast<std::size_t>(bins_) + static_cast<std::size_t>(bin)];
  }
  /// Cost of a step into a cell after another step; `before` is null at the start.
  double cost(const HybridStep* before, const HybridStep& step, std::uint8_t cellCost) const;

 private:
  void addTurn(int bins, double radius, double length);

  CarMotion car_;
  int bins_;
  double binSize_, radius_;
  double nonStraightPenalty_, changePenalty_, reversePenalty_, costPenalty_, reward_;
  bool isQuadratic_;
  std::vector<HybridStep> steps_;
  std::vector<Vec2> offsets_;
};

/// One search of Smac Hybrid-A*. Positions in cells of the costmap; (0, 0) is its lower left
/// corner.
class HybridSearch {
 public:
  /// All references must outlive the search; `costmap` has the resolution of the search.
  struct Context {
    const SmacHybridParameters& parameters;
    Distro distro;
    const HybridMotion& motion;
    const Costmap& costmap;
    const PlanRequest& request;  // its footprint and stop flag are used
    ObstacleHeuristic& obstacles;
    DistanceHeuristic& curves;
  };
  explicit HybridSearch(const Context& context);

  /// The cost of the robot's cell at a pose, or nullopt in a collision.
  std::optional<std::uint8_t> costAt(const Pose2& pose) const;

  /// Finds a path from the start to a goal, or as near as the tolerance allows. All goals have the
  /// same position; headings are multiples of the bin.
  PlanResult find(const Pose2& start, const std::vector<Pose2>& goals);

 private:
  struct Node {
    Pose2 pose;  // heading = bin * bin size
    double g = 0.0;
    int bin = 0;
    int step = -1;  // step into this node; -1: start
    int parent = -1;
    std::uint8_t cost = 0;
    bool isVisited = false;
  };
  struct Expansion {  // schedule of analytic expansions
    int due = 0;
    int closest = 1 << 30;  // minimum estimate so far [cells]
  };

  void begin(const Pose2& start, const std::vector<Pose2>& goals);
  int nodeAt(const Vec2& place, int bin);
  bool isInside(const Vec2& place) const;
  double estimate(const Node& node);
  void expand(int index);
  void applyStep(int from, std::size_t step);
  std::optional<Path> connectToGoal(int index);
  std::optional<Path> tryAnalyticExpansion(int index);
  std::optional<Path> analyticExpansionFrom(const Node& node, const Pose2& goal) const;
  bool isTooCostly(const std::vector<std::uint8_t>& costs, double length) const;
  std::optional<Path> shortestToGoals(const Node& node, const Pose2*& goal) const;
  double curveLength(const Node& node, const Pose2& goal) const;
  const Node* ancestorOf(const Node& node) const;
  Path pathTo(int index) const;

  Context context_;
  std::vector<Pose2> goals_;
  std::vector<int> goalNodes_;
  std::vector<Node> nodes_;
  std::vector<std::int32_t> blockOf_;  // per cell: index of its bins in `slots_`; -1: none yet
  std::vector<std::int32_t> slots_;    // per cell and bin: index of its node; -1: none yet
  OpenList<double> open_;
  NearestNode nearest_;
  Expansion expansion_;
};

}  // namespace sim2d::nav2
